//! Path tracing: camera ray → path loop → radiance. Twin of `shaders/integrator/path/`.
//!
//! The kernel traces a vertex's shadow ray one turn later, together with the extension ray; decisions, random numbers
//! and the order of every sum are the same.

pub mod connect;
pub mod direct;
pub mod pick;
pub mod record;
pub mod signature;

use crate::prepared::MaterialKind;
use crate::reference::bsdf::LOBE_NONE;
use crate::reference::camera::camera_ray;
use crate::reference::math::finite::is_black;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::extend::extend;
use crate::reference::path::roulette::LONG_PATH;
use crate::reference::path::trace::extend_ray;
use crate::reference::path::vertex::{Vertex, path_vertex};
use crate::reference::path::{SampleId, Subpath, depth_reached};
use crate::reference::sampler::camera_block;
use crate::reference::world::World;
use crate::settings::Settings;
use connect::hit_weight;
use pick::{pick_normal, pick_probability};
use record::Recorder;

/// The state of a sample.
#[derive(Clone, Copy, Debug)]
pub struct PathState<F> {
    pub path: Subpath<F>,
    pub radiance: Vec3<F>,
    /// The argument of [`pick_probability`] for the last vertex.
    pub pick_normal: Vec3<F>,
    /// Rays traced so far.
    pub rays: u64,
    /// The throughput has dropped below the least that the scalar can represent: the path ends.
    pub underflow: bool,
}

/// Radiance of one path, and its counters.
#[derive(Clone, Copy, Debug)]
pub struct PathResult<F> {
    pub radiance: Vec3<F>,
    pub rays: u64,
    /// It reached [`LONG_PATH`] bounces.
    pub long: bool,
    /// It ended because of an underflow.
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
        let origin = s.path.ray.o;
        let (hit, distance) = extend_ray(world, settings, &mut s.path, &mut s.rays);
        let Some(hit) = hit else {
            let seen = s.path.throughput
                * background_seen(world, settings, &s.path, s.pick_normal, origin);
            recorder.emission(seen);
            s.radiance += seen;
            recorder.escape(&s);
            break;
        };
        let v = path_vertex(
            world,
            settings,
            s.path.ray,
            hit,
            distance,
            s.path.throughput,
        );
        recorder.hit(&s, &v);
        let seen = s.path.throughput
            * emission_seen(
                world,
                settings,
                &s.path,
                s.pick_normal,
                &v,
                origin,
                distance,
            );
        recorder.emission(seen);
        s.radiance += seen;
        let black = world.materials[v.material as usize].kind == MaterialKind::Black;
        // A path starts with some light: a path with none has lost it to absorption.
        s.underflow = is_black(s.path.throughput);
        if black || depth_reached(settings, s.path.bounce) || s.underflow {
            recorder.vertex(&s, &v, LOBE_NONE);
            break;
        }
        direct::connect(world, settings, &mut s, &v, id, recorder);
        alive = go_on(world, settings, &mut s, &v, id, recorder);
    }
    PathResult {
        radiance: s.radiance,
        rays: s.rays,
        long: s.path.bounce >= LONG_PATH,
        underflow: s.underflow,
    }
}

/// Continues in the next direction; false where the path ends.
fn go_on<F: Real>(
    world: &World<F>,
    settings: &Settings,
    s: &mut PathState<F>,
    v: &Vertex<F>,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
) -> bool {
    s.pick_normal = pick_normal(world, settings, v);
    let e = extend(settings, Origin::Eye, &mut s.path, v, id);
    s.underflow = e.underflow;
    // A broken throughput breaks the sample, which the film then drops and counts.
    if e.broken {
        s.radiance += s.path.throughput;
    }
    recorder.vertex(s, v, e.lobe);
    e.alive
}

/// The camera ray through a point of the pixel, from the eye or a point of its lens.
pub fn begin_path<F: Real>(world: &World<F>, settings: &Settings, id: SampleId) -> PathState<F> {
    let u = id.words(settings, camera_block());
    PathState {
        path: Subpath {
            ray: camera_ray(world, id, u),
            throughput: Vec3::one(),
            eta_scale: F::one(),
            pdf: F::zero(),
            delta: true,
            bounce: 0,
        },
        radiance: Vec3::zero(),
        pick_normal: Vec3::zero(),
        rays: 0,
        underflow: false,
    }
}

/// Weighted radiance of an emitter that the path has hit; the density is taken from the last real vertex, `origin`, of
/// [`pick_normal`] `n`, `distance` away.
fn emission_seen<F: Real>(
    world: &World<F>,
    settings: &Settings,
    path: &Subpath<F>,
    n: Vec3<F>,
    v: &Vertex<F>,
    origin: Vec3<F>,
    distance: F,
) -> Vec3<F> {
    match world.light_of(v.shape) {
        None => Vec3::zero(),
        Some(light) => {
            let cosine = dot3(path.ray.d, v.ng).abs();
            let expected = pick_probability(world, settings, light, origin, n);
            let q = expected * world.light_pdf(light, origin, v.prim, cosine, distance);
            let connect = settings.estimator.connect;
            world.lights[light].radiance * hit_weight(connect, path.delta, path.pdf, q)
        }
    }
}

/// Weighted radiance of the surroundings.
fn background_seen<F: Real>(
    world: &World<F>,
    settings: &Settings,
    path: &Subpath<F>,
    n: Vec3<F>,
    origin: Vec3<F>,
) -> Vec3<F> {
    match world.background_light {
        None => Vec3::zero(),
        Some(light) => {
            let expected = pick_probability(world, settings, light, origin, n);
            let outside = world.outside_seen(light, path.ray.d);
            let q = expected * outside.pdf;
            let connect = settings.estimator.connect;
            outside.radiance * hit_weight(connect, path.delta, path.pdf, q)
        }
    }
}
