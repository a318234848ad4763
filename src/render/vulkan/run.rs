//! A rendering by any integrator, for all callers that advance it.

use std::ops::Range;
use std::time::Duration;

use super::limits::DispatchLimits;
use super::rendering::Rendering;
use crate::features::Features;
use crate::gpu::{Device, DeviceKind};
use crate::part::{AnyPart, Part};
use crate::render::follow::Grows;
use crate::render::several::Ranges;
use crate::render::slices::Slices;
use crate::render::{HostFilm, Job, NEAREST, RenderError, Stats, empty_part};

/// A rendering in progress.
pub struct Run<'a, R> {
    job: &'a Job<'a>,
    device: &'a Device,
    limits: DispatchLimits,
    features: Features,
    compile_s: f64,
    pub rendering: R,
}

impl<'a, R: Rendering<'a>> Run<'a, R> {
    /// Everything is compiled.
    pub fn new(
        job: &'a Job<'a>,
        device: &'a Device,
        limits: DispatchLimits,
    ) -> Result<Self, RenderError> {
        let features = job.features();
        let mut rendering = R::new(job, device, &features, limits)?;
        Ok(Self {
            compile_s: rendering.compile()?.as_secs_f64(),
            job,
            device,
            limits,
            features,
            rendering,
        })
    }
}

impl<'a, R: Rendering<'a>> Ranges for Run<'a, R> {
    fn make(&mut self, samples: Range<u32>) -> Result<Part<f32>, RenderError> {
        self.rendering.go_on(empty_part(self.job, samples.start))?;
        let mut slices = Slices::new(self.limits.dispatch_time);
        let mut done = samples.start;
        while done < samples.end {
            let slice = slices.next(samples.end - done);
            let longest = self.rendering.advance(done + slice, &mut |_| {})?;
            slices.took(slice, longest);
            done += slice;
        }
        Ok(self.rendering.film().part())
    }

    fn took(&self) -> Stats {
        self.stats()
    }
}

impl<'a, R: Rendering<'a>> Grows for Run<'a, R> {
    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError> {
        self.rendering.advance(samples, progress)
    }

    fn part(&self) -> AnyPart {
        AnyPart::F32(self.rendering.film().part())
    }

    fn stats(&self) -> Stats {
        let costs = self.rendering.costs();
        let info = self.device.info();
        Stats {
            device: info.name.clone(),
            driver: info.driver.clone(),
            rounding: match info.kind {
                DeviceKind::Cpu => NEAREST.to_owned(),
                _ => format!("as {}, {} do", info.name, info.driver),
            },
            set_up: costs.set_up,
            compile_s: self.compile_s,
            gpu_s: Some(costs.gpu_time.as_secs_f64()),
            features: self.features.names(),
            spirv_bytes: costs.spirv_bytes,
            buffers: self.rendering.buffers(),
            ..Stats::default()
        }
    }
}
