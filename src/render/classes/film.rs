//! The sums of all classes, pixel by pixel.

use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use super::both_paths::BothPaths;
use super::eye_path::EyePath;
use super::sample::Share;
use crate::film::Channel;
use crate::path_class::PathClass;
use crate::reference::film::{PixelSum, is_summable};
use crate::reference::integrator::bidirectional::{Transport, Ways, trace_bidirectional};
use crate::reference::integrator::light::{Splat, trace_light};
use crate::reference::integrator::path::trace_path;
use crate::reference::world::World;
use crate::render::Job;
use crate::render::light_film::with_splat;
use crate::render::tiles::Tile;
use crate::sample::Address;
use crate::settings::Integrator;

/// The bytes of a pixel for each class: two sums, and the channels.
pub const PIXEL_BYTES: u64 = (2 * size_of::<DVec3>() + size_of::<[f32; 3]>()) as u64;

/// Sums over samples.
pub struct ClassFilm {
    area: Tile,
    /// Pixel by pixel, a value a class.
    sums: Vec<DVec3>,
    /// Contributions to the current sample index, to which light paths contribute from everywhere: split, and whole as
    /// in the picture's film.
    split: Vec<DVec3>,
    whole: Vec<PixelSum<f32>>,
}

/// The contributions of the paths of a row of pixels.
struct Row {
    splats: Vec<Splat<f32>>,
    /// By eye paths.
    seen: Vec<Splat<f32>>,
    shares: Vec<Share>,
}

impl ClassFilm {
    /// No samples yet.
    pub fn new(job: &Job) -> Self {
        let area = job.area();
        let pixels = area.pixels() as usize;
        let from_everywhere = match job.settings.estimator.integrator {
            Integrator::Path => 0,
            Integrator::Light | Integrator::Bidirectional => pixels,
        };
        Self {
            area,
            sums: vec![DVec3::ZERO; pixels * job.classes.len()],
            split: vec![DVec3::ZERO; from_everywhere * job.classes.len()],
            whole: vec![PixelSum::zero(); from_everywhere],
        }
    }

    /// Adds samples of path tracing to every pixel. A sample that the picture's film drops is dropped from all classes.
    pub fn add_eye_paths(&mut self, job: &Job, world: &World<f32>, indices: Range<u32>) {
        let area = self.area;
        let pixels = self.sums.par_chunks_mut(job.classes.len()).enumerate();
        pixels.for_each(|(i, sums)| {
            let pixel = area.pixel(i as u32);
            for index in indices.clone() {
                let id = job.sample(Address { pixel, index });
                let mut path = EyePath::new(&job.settings, job.classes);
                let result = trace_path(world, &job.settings, id, &mut path);
                if is_summable(result.radiance) {
                    let brought = path.brought();
                    sums.iter_mut().zip(brought).for_each(|(sum, x)| *sum += x);
                }
            }
        });
    }

    /// Adds one sample of light tracing or of bidirectional path tracing to every pixel, in the order of the picture's film.
    pub fn add_both_paths(&mut self, job: &Job, world: &World<f32>, index: u32) {
        let rows = (0..job.prepared.camera.height).into_par_iter();
        let rows: Vec<Row> = rows.map(|row| Row::new(job, world, row, index)).collect();
        self.split.fill(DVec3::ZERO);
        self.whole.fill(PixelSum::zero());
        let width = job.prepared.camera.width;
        let place = |pixel: u32| self.area.index([pixel % width, pixel / width]) as usize;
        let splats = rows.iter().flat_map(|row| &row.splats);
        for splat in splats.chain(rows.iter().flat_map(|row| &row.seen)) {
            let whole = &mut self.whole[place(splat.pixel)];
            *whole = with_splat(*whole, splat.value);
        }
        let classes = job.classes.len();
        for share in rows.iter().flat_map(|row| &row.shares) {
            self.split[place(share.pixel) * classes + share.class] += share.value;
        }
        let split = self.split.chunks(classes).zip(&self.whole);
        for (sums, (split, whole)) in self.sums.chunks_mut(classes).zip(split) {
            if is_summable(whole.sum) {
                sums.iter_mut().zip(split).for_each(|(sum, x)| *sum += *x);
            }
        }
    }

    /// The mean of `spp` samples.
    pub fn channels(&self, job: &Job, spp: u32) -> Vec<Channel> {
        let channel = |number: usize, class: &PathClass, (i, end): (usize, &str)| {
            let values = self.sums.iter().skip(number).step_by(job.classes.len());
            Channel {
                name: format!("{}.{end}", class.layer()).into(),
                values: values.map(|sum| (sum[i] / f64::from(spp)) as f32).collect(),
            }
        };
        let ends = ["R", "G", "B"].into_iter().enumerate();
        let of = |(number, class)| ends.clone().map(move |end| channel(number, class, end));
        job.classes.iter().enumerate().flat_map(of).collect()
    }
}

impl Row {
    fn new(job: &Job, world: &World<f32>, row: u32, index: u32) -> Self {
        let (settings, adjoint) = (&job.settings, &job.settings.adjoint());
        let transport = Transport {
            world,
            settings,
            adjoint,
            ways: Ways::All,
        };
        let window = job.area().window();
        let mut all = Self {
            splats: Vec::new(),
            seen: Vec::new(),
            shares: Vec::new(),
        };
        for column in 0..job.prepared.camera.width {
            let pixel = [column, row];
            let id = job.sample(Address { pixel, index });
            let mut paths = BothPaths::new(settings, adjoint, job.classes);
            let mut take = |splat| all.splats.push(splat);
            let radiance = match settings.estimator.integrator {
                Integrator::Bidirectional => {
                    trace_bidirectional(transport, window, id, &mut paths, &mut take).0
                }
                _ => {
                    trace_light(world, adjoint, window, id, &mut paths, &mut take);
                    None
                }
            };
            let pixel = id.pixel;
            all.seen
                .extend(radiance.map(|value| Splat { value, pixel }));
            all.shares.extend(paths.sample.shares(pixel));
        }
        all
    }
}
