//! Paths from lights by the reference, alone or with paths from the eye: one row of pixels at a time, their splats
//! added in order.

use rayon::prelude::*;

use super::Render;
use crate::part::{Part, Scalar};
use crate::reference::integrator::bidirectional::record::Silent;
use crate::reference::integrator::bidirectional::{Transport, Ways, trace_bidirectional};
use crate::reference::integrator::light;
use crate::reference::integrator::light::{LightCounts, Splat, trace_light};
use crate::reference::world::World;
use crate::render::{Job, LightFilm};
use crate::sample::Address;
use crate::settings::Integrator;

/// Rows traced at once, of several sample indices if a picture has fewer rows.
const ROWS: u32 = 256;

/// The contributions of the paths of a row of pixels.
struct Row<F> {
    splats: Vec<Splat<F>>,
    /// By eye paths.
    seen: Vec<Splat<F>>,
    counts: Vec<LightCounts>,
}

impl<F: Scalar> Render<F> for LightFilm<F> {
    fn new(job: &Job, part: Part<F>) -> Self {
        Self::new(job, part)
    }

    fn advance(&mut self, job: &Job, world: &World<F>, samples: u32) {
        let (settings, adjoint) = (job.settings, job.settings.adjoint());
        let transport = Transport {
            world,
            settings: &settings,
            adjoint: &adjoint,
            ways: Ways::All,
        };
        let both = settings.estimator.integrator == Integrator::Bidirectional;
        let window = self.window();
        let row = |row: u32, sample: u32| {
            let mut arrived = Row {
                splats: Vec::new(),
                seen: Vec::new(),
                counts: Vec::new(),
            };
            for column in 0..job.prepared.camera.width {
                let id = job.sample(Address {
                    pixel: [column, row],
                    index: sample,
                });
                let mut take = |splat| arrived.splats.push(splat);
                let (radiance, counts) = match both {
                    true => trace_bidirectional(transport, window, id, &mut Silent, &mut take),
                    false => {
                        let recorder = &mut light::record::Silent;
                        let counts = trace_light(world, &adjoint, window, id, recorder, &mut take);
                        (None, counts)
                    }
                };
                let pixel = id.pixel;
                arrived
                    .seen
                    .extend(radiance.map(|value| Splat { value, pixel }));
                arrived.counts.push(counts);
            }
            arrived
        };
        let height = job.prepared.camera.height;
        let indices: Vec<u32> = (self.done()..samples).collect();
        for indices in indices.chunks((ROWS / height).max(1) as usize) {
            let rows = (0..height * indices.len() as u32).into_par_iter();
            let rows = rows.map(|i| row(i % height, indices[(i / height) as usize]));
            let rows: Vec<Row<F>> = rows.collect();
            for rows in rows.chunks(height as usize) {
                let splats = rows.iter().flat_map(|row| &row.splats);
                let seen = rows.iter().flat_map(|row| &row.seen);
                splats.chain(seen).for_each(|&splat| self.splat(splat));
                let counts = rows.iter().flat_map(|row| &row.counts);
                counts.for_each(|&counts| self.count(counts));
                self.end_sample();
            }
            self.end_pass();
        }
    }
}
