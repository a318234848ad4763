//! Bidirectional path tracing: its weights by brute force, and its pictures against those of path tracing.

mod aim;
mod battery;
mod chain;
mod emission;
mod pictures;
mod stability;
mod trace;
mod weights;

use vkpt::prepared::Prepared;
use vkpt::reference::integrator::light::splat::Window;
use vkpt::reference::path::SampleId;

/// Every sample of a picture, one index after the other.
fn samples(prepared: &Prepared, spp: u32, seed: u32) -> impl Iterator<Item = SampleId> {
    let width = prepared.camera.width;
    let pixels = width * prepared.camera.height;
    (0..pixels * spp).map(move |k| SampleId {
        column: k % pixels % width,
        row: k % pixels / width,
        pixel: k % pixels,
        sample: k / pixels,
        seed,
    })
}

/// All pixels of a picture.
fn whole(prepared: &Prepared) -> Window {
    Window {
        x: 0,
        y: 0,
        width: prepared.camera.width,
        height: prepared.camera.height,
    }
}
