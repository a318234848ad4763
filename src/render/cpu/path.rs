//! Path tracing by the reference: each pixel separately.

use super::Render;
use crate::part::{Part, Scalar};
use crate::reference::integrator::path::record::Silent;
use crate::reference::integrator::path::trace_path;
use crate::reference::world::World;
use crate::render::{Job, Pixels};
use crate::sample::Address;

impl<F: Scalar> Render<F> for Pixels<F> {
    fn new(job: &Job, part: Part<F>) -> Self {
        Self::new(job.area(), part)
    }

    fn advance(&mut self, job: &Job, world: &World<F>, samples: u32) {
        let area = self.area;
        while self.done() < samples {
            let indices = self.done()..self.stop(samples);
            self.each(|i, mut pixel| {
                let at = area.pixel(i as u32);
                for sample in indices.clone() {
                    let id = job.sample(Address {
                        pixel: at,
                        index: sample,
                    });
                    let path = trace_path(world, &job.settings, id, &mut Silent);
                    pixel.add(path.radiance);
                    pixel.film.rays += path.rays;
                    pixel.film.long_paths += u64::from(path.long);
                    pixel.film.underflows += u64::from(path.underflow);
                }
            });
            self.settle();
        }
    }
}
