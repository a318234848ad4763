//! Path tracing by the reference: each pixel by itself.

use std::ops::Range;

use super::Render;
use crate::reference::integrator::path::record::Silent;
use crate::reference::integrator::path::trace_path;
use crate::reference::math::Real;
use crate::reference::world::World;
use crate::render::{Job, Pixels};
use crate::sample::Address;

impl<F: Real> Render<F> for Pixels<F> {
    fn new(job: &Job) -> Self {
        Self::new(job)
    }

    fn advance(&mut self, job: &Job, world: &World<F>, samples: Range<u32>) {
        let area = self.area;
        self.each(|i, mut pixel| {
            let at = area.pixel(i as u32);
            for sample in samples.clone() {
                let id = job.sample(Address {
                    pixel: at,
                    index: sample,
                });
                let path = trace_path(world, &job.settings, id, &mut Silent);
                pixel.add(path.radiance, sample);
                pixel.film.rays += path.rays;
                pixel.film.long_paths += u64::from(path.long);
                pixel.film.underflows += u64::from(path.underflow);
            }
        });
    }
}
