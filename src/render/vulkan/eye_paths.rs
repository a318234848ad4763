//! Eye paths of a tile on a device, joined to the light paths of the same samples: the second half of bidirectional path
//! tracing.

use std::time::{Duration, Instant};

use super::device_film::buffer;
use super::kernel::Kernel;
use super::light_paths::{Arrived, LightPaths, read_lanes};
use crate::gpu::{Buffer, Device};
use crate::layout::{EyeState, LightSlice, Radiance, Reservoir};
use crate::reference::integrator::light::Splat;
use crate::reference::math::vec3;
use crate::render::plan::EyePlan;
use crate::render::{Job, LightFilm, RenderError};

/// The buffers of eye paths, and those that light paths fill for them.
pub struct EyePaths {
    paths: Buffer,
    radiances: Buffer,
    vertices: Buffer,
    reservoirs: Buffer,
}

impl EyePaths {
    /// As planned.
    pub fn new(device: &Device, plan: &EyePlan, kernel: &mut Kernel) -> Result<Self, RenderError> {
        let start = Instant::now();
        let paths = Self {
            paths: buffer(device, &plan.paths)?,
            radiances: buffer(device, &plan.radiances)?,
            vertices: buffer(device, &plan.vertices)?,
            reservoirs: buffer(device, &plan.reservoirs)?,
        };
        kernel.costs.set_up.upload += start.elapsed().as_secs_f64();
        Ok(paths)
    }

    /// The chains of the vertices of light paths, index after index, thread after thread.
    pub fn decided(&self, count: usize) -> Result<Vec<u32>, RenderError> {
        let mut reservoirs = vec![Reservoir::default(); count];
        self.reservoirs
            .read_into(bytemuck::cast_slice_mut(&mut reservoirs))?;
        Ok(reservoirs.iter().map(|r| r.decided).collect())
    }

    /// The buffers that light paths write, in the order of their bindings.
    pub fn kept(&self) -> [&Buffer; 2] {
        [&self.vertices, &self.reservoirs]
    }

    /// In the order of their bindings.
    pub fn buffers(&self) -> [&Buffer; 4] {
        [
            &self.paths,
            &self.radiances,
            &self.vertices,
            &self.reservoirs,
        ]
    }

    /// Follows, with pipeline 1, the eye paths of the samples whose light paths pipeline 0 has followed; returns their
    /// contributions to the pixels of the film, and their signatures.
    pub fn trace(
        &self,
        job: &Job,
        kernel: &mut Kernel,
        light: &LightPaths,
        slice: &LightSlice,
        film: &mut LightFilm<f32>,
        take: &mut impl FnMut(Arrived, u32),
    ) -> Result<Duration, RenderError> {
        let threads = slice.tile_width * slice.tile_height;
        let fresh = EyeState {
            done: slice.sample_begin,
            ..EyeState::default()
        };
        let states = vec![fresh; threads as usize];
        self.paths.write(bytemuck::cast_slice(&states))?;
        let slice = LightSlice {
            eye_medium: job.prepared.eye_medium,
            ..*slice
        };
        let mut longest = Duration::ZERO;
        loop {
            let [paths, others @ ..] = self.buffers();
            let state = [paths, &light.lanes].into_iter().chain(others);
            longest = longest.max(kernel.dispatch(1, state, &slice, threads)?);
            let lanes = read_lanes(&light.lanes, threads, film)?;
            if lanes.iter().all(|lane| lane.unfinished == 0) {
                break;
            }
        }
        self.read(job, &slice, take)?;
        Ok(longest)
    }

    fn read(
        &self,
        job: &Job,
        slice: &LightSlice,
        take: &mut impl FnMut(Arrived, u32),
    ) -> Result<(), RenderError> {
        let threads = slice.tile_width * slice.tile_height;
        let indices = slice.sample_begin..slice.sample_end;
        let mut radiances = vec![Radiance::default(); threads as usize * indices.len()];
        self.radiances
            .read_into(bytemuck::cast_slice_mut(&mut radiances))?;
        let area = job.area();
        let width = job.prepared.camera.width;
        for (radiances, index) in radiances.chunks(threads as usize).zip(indices) {
            for (radiance, thread) in radiances.iter().zip(0..) {
                let column = slice.tile_x + thread % slice.tile_width;
                let row = slice.tile_y + thread / slice.tile_width;
                if area.contains([column, row]) {
                    let [r, g, b] = radiance.value;
                    let splat = Splat {
                        value: vec3(r, g, b),
                        pixel: row * width + column,
                    };
                    let arrived = Arrived {
                        thread,
                        index,
                        splat,
                    };
                    take(arrived, radiance.signature);
                }
            }
        }
        Ok(())
    }
}
