//! Random decisions of a path have their frequencies: where in its pixel it starts, which light and which triangle it connects
//! to, whether it continues. Through the functions that paths are made of; by the reference in f64, whose random numbers are
//! the device's.
//!
//! Fixed seeds; each family of tests has the level α = 1e-3, divided after Šidák.

mod light_tree;
mod lights;
mod pixel;
mod roulette;

use vkpt::reference::integrator::path::record::Recorder;
use vkpt::reference::integrator::path::{PathState, trace_path};
use vkpt::reference::math::Vec3;
use vkpt::reference::path::SampleId;
use vkpt::reference::path::trace::ShadowRay;
use vkpt::reference::path::vertex::Vertex;
use vkpt::reference::world::World;
use vkpt::settings::Settings;

use crate::common;

/// Level of a family of tests.
const ALPHA: f64 = 1e-3;

/// The result of a path.
#[derive(Default)]
struct Story {
    /// Surfaces that it met.
    vertices: usize,
    /// Its last direction, if it left the scene.
    escaped: Option<Vec3<f64>>,
}

impl Recorder<f64> for Story {
    fn vertex(&mut self, _: &PathState<f64>, _: &Vertex<f64>, _: u32) {
        self.vertices += 1;
    }
    fn connection(&mut self, _: &PathState<f64>, _: &ShadowRay<f64>, _: Option<Vec3<f64>>) {}
    fn escape(&mut self, s: &PathState<f64>) {
        self.escaped = Some(s.path.ray.d);
    }
}

/// The story of sample `sample` of a pixel.
fn story(world: &World<f64>, settings: &Settings, [column, row]: [u32; 2], sample: u32) -> Story {
    let mut story = Story::default();
    let id = SampleId {
        column,
        row,
        pixel: row * world.width + column,
        sample,
        seed: 5,
    };
    trace_path(world, settings, id, &mut story);
    story
}

fn world(text: &str, settings: &Settings) -> World<f64> {
    World::new(&common::render::prepared(text, settings))
}
