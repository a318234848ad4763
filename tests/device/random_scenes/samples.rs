//! Every sample of a case, by all available renderers.

use std::sync::atomic::AtomicBool;

use vkpt::gpu::DeviceKind;
use vkpt::prepared::Prepared;
use vkpt::reference::integrator::path::record::Silent;
use vkpt::reference::integrator::path::trace_path;
use vkpt::reference::math::Real;
use vkpt::reference::path::SampleId;
use vkpt::reference::world::World;
use vkpt::render::{Job, KernelChoice, paired};

use super::case::Case;
use crate::common;
use crate::common::render::job;

/// All radiances that a renderer made: of a pixel's samples one after the other, row by row.
pub struct Made {
    pub by: &'static str,
    pub spp: u32,
    pub radiances: Vec<[f64; 3]>,
}

impl Made {
    /// The mean of each pixel.
    pub fn pixels(&self) -> Vec<[f64; 3]> {
        let mean = |samples: &[[f64; 3]]| {
            let sum = samples
                .iter()
                .fold([0.0; 3], |sum, s| [0, 1, 2].map(|c| sum[c] + s[c]));
            sum.map(|x| x / samples.len() as f64)
        };
        self.radiances.chunks(self.spp as usize).map(mean).collect()
    }
}

/// Which renderers are tried.
#[derive(Clone, Copy)]
pub enum By<'a> {
    /// cpu-f32 and cpu-f64.
    References,
    /// The device, by this kernel, first.
    All(KernelChoice<'a>),
}

/// All, by the kernel that is composed for the case.
pub const COMPOSED: By<'static> = By::All(KernelChoice::Composed);

/// Every sample of a case; `None` if a device is wanted and the run skips devices.
pub fn made(by: By, case: &Case, prepared: &Prepared, spp: u32) -> Option<Vec<Made>> {
    match by {
        By::References => Some(vec![
            by_reference::<f32>("cpu-f32", case, prepared, spp),
            by_reference::<f64>("cpu-f64", case, prepared, spp),
        ]),
        By::All(kernel) => by_all(case, prepared, spp, kernel),
    }
}

fn by_reference<F: Real>(by: &'static str, case: &Case, prepared: &Prepared, spp: u32) -> Made {
    let world = World::<F>::new(prepared);
    let pixels = (0..prepared.camera.width * prepared.camera.height)
        .map(|pixel| (pixel % prepared.camera.width, pixel / prepared.camera.width));
    let samples = pixels.flat_map(|place| (0..spp).map(move |sample| (place, sample)));
    let radiance = |((column, row), sample)| {
        let id = SampleId {
            column,
            row,
            pixel: row * prepared.camera.width + column,
            sample,
            seed: case.seed,
        };
        let path = trace_path(&world, &case.settings, id, &mut Silent);
        path.radiance.f64().to_array()
    };
    Made {
        by,
        spp,
        radiances: samples.map(radiance).collect(),
    }
}

fn by_all(case: &Case, prepared: &Prepared, spp: u32, kernel: KernelChoice) -> Option<Vec<Made>> {
    let device = common::device()?;
    let job = Job {
        kernel,
        ..job(prepared, case.settings, spp, case.seed)
    };
    let mut all = ["the device", "cpu-f32", "cpu-f64"].map(|by| Made {
        by,
        spp,
        radiances: Vec::new(),
    });
    let stop = AtomicBool::new(false);
    let ended = paired(&job, device, &stop, &mut |_| {}, &mut |s| {
        for (made, path) in all.iter_mut().zip([s.device, s.f32, s.f64]) {
            made.radiances.push(path.radiance);
        }
    });
    ended.unwrap_or_else(|e| panic!("{e}\n{case:?}"));
    Some(all.into())
}

/// Whether the device must have the bits of cpu-f32.
pub fn rounds_as_the_reference() -> bool {
    common::device().is_some_and(|d| d.info().kind == DeviceKind::Cpu)
}
