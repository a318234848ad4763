//! One sample of one pixel: camera ray → path loop → radiance. Twin of `shaders/path_trace.comp` and `shaders/path/`.
//!
//! The kernel flies a vertex's shadow ray one turn later, together with the extension ray; decisions, random
//! numbers and the order of every sum are the same.

pub mod connect;
pub mod direct;
pub mod extend;
pub mod flight;
pub mod medium;
pub mod record;
pub mod roulette;
pub mod signature;
pub mod throughput;
pub mod vertex;

use super::camera::camera_direction;
use super::math::finite::is_black;
use super::math::{Real, Vec3, dot3};
use super::sampler::{camera_block, sampler_block, unit_float};
use super::shape::Ray;
use super::world::World;
use crate::prepared::MaterialKind;
use crate::settings::Settings;
use connect::hit_weight;
use record::Recorder;
use vertex::Vertex;

/// Which random numbers a path draws.
#[derive(Clone, Copy, Debug)]
pub struct SampleId {
    pub column: u32,
    /// From the top.
    pub row: u32,
    /// row · width + column of the full picture.
    pub pixel: u32,
    pub sample: u32,
    pub seed: u32,
}

impl SampleId {
    /// The four words of a block of [`sampler::dimensions`](super::sampler::dimensions).
    fn words(self, settings: &Settings, block: u32) -> [u32; 4] {
        let sampler = settings.estimator.sampler;
        sampler_block(sampler, self.pixel, self.sample, block, self.seed)
    }
}

/// What carries over from one vertex to the next.
#[derive(Clone, Copy, Debug)]
pub struct PathState<F> {
    pub ray: Ray<F>,
    pub throughput: Vec3<F>,
    pub radiance: Vec3<F>,
    /// Product of the eta² that radiance scaling has put into `throughput`.
    pub eta_scale: F,
    /// Density of the ray's direction; without meaning where `delta` is set.
    pub pdf: F,
    /// The ray comes from the camera or from a delta lobe.
    pub delta: bool,
    /// Material that the ray travels in, or `NONE`.
    pub medium: u32,
    pub bounce: u32,
    /// Rays flown so far.
    pub rays: u64,
    /// Less is left of `throughput` than the scalar can hold: the path ends.
    pub underflow: bool,
}

/// Radiance that one path brought back, and what it took.
#[derive(Clone, Copy, Debug)]
pub struct PathResult<F> {
    pub radiance: Vec3<F>,
    pub rays: u64,
    /// It reached [`roulette::LONG_PATH`] bounces.
    pub long: bool,
    /// It ended for an underflow.
    pub underflow: bool,
}

/// Follows one path from the camera to its end.
pub fn trace_path<F: Real>(
    world: &World<F>,
    settings: &Settings,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
) -> PathResult<F> {
    let mut s = begin_path(world, settings, id);
    let mut alive = true;
    while alive {
        let origin = s.ray.o;
        let (hit, distance) = flight::extend_ray(world, settings, &mut s);
        let Some(hit) = hit else {
            s.radiance += s.throughput * background_seen(world, settings, &s);
            recorder.escape(&s);
            break;
        };
        let v = vertex::path_vertex(world, settings, s.ray, hit, distance);
        recorder.hit(&s, &v);
        s.radiance += s.throughput * emission_seen(world, settings, &s, &v, origin, distance);
        let black = world.materials[v.material as usize].kind == MaterialKind::Black;
        // A path sets out with some light: what has none has lost it to absorption.
        s.underflow = is_black(s.throughput);
        if black || depth_reached(settings, s.bounce) || s.underflow {
            recorder.vertex(&s, &v, 0);
            break;
        }
        direct::connect(world, settings, &mut s, &v, id, recorder);
        alive = extend::extend(settings, &mut s, &v, id, recorder);
    }
    PathResult {
        radiance: s.radiance,
        rays: s.rays,
        long: s.bounce >= roulette::LONG_PATH,
        underflow: s.underflow,
    }
}

fn begin_path<F: Real>(world: &World<F>, settings: &Settings, id: SampleId) -> PathState<F> {
    let u = id.words(settings, camera_block());
    let d = camera_direction(
        &world.camera,
        id.column,
        id.row,
        unit_float(u[0]),
        unit_float(u[1]),
    );
    PathState {
        ray: Ray::new(world.camera.eye, d),
        throughput: Vec3::one(),
        radiance: Vec3::zero(),
        eta_scale: F::one(),
        pdf: F::zero(),
        delta: true,
        medium: world.eye_medium,
        bounce: 0,
        rays: 0,
        underflow: false,
    }
}

/// Whether a path of so many bounces goes no further; never without a `--max-depth`.
fn depth_reached(settings: &Settings, bounce: u32) -> bool {
    settings.model.max_depth.is_some_and(|n| bounce >= n)
}

/// Weighted radiance of an emitter that the path has hit; the density runs from the last real vertex,
/// `origin`, `distance` away.
fn emission_seen<F: Real>(
    world: &World<F>,
    settings: &Settings,
    s: &PathState<F>,
    v: &Vertex<F>,
    origin: Vec3<F>,
    distance: F,
) -> Vec3<F> {
    match world.light_of(v.shape) {
        None => Vec3::zero(),
        Some(light) => {
            let cosine = dot3(s.ray.d, v.ng).abs();
            let q =
                world.light_pmf(light) * world.light_pdf(light, origin, v.prim, cosine, distance);
            let connect = settings.estimator.connect;
            world.lights[light].radiance * hit_weight(connect, s.delta, s.pdf, q)
        }
    }
}

/// Weighted radiance of everything outside.
fn background_seen<F: Real>(world: &World<F>, settings: &Settings, s: &PathState<F>) -> Vec3<F> {
    match world.background_light {
        None => Vec3::zero(),
        Some(light) => {
            let q = world.light_pmf(light) * super::light::background_light_pdf();
            let connect = settings.estimator.connect;
            world.lights[light].radiance * hit_weight(connect, s.delta, s.pdf, q)
        }
    }
}
