//! The start of a light path: a point of a light, and a direction about its normal; twin of
//! `shaders/integrator/light/begin.glsl`.

use crate::reference::bsdf::diffuse::lambert::cosine_lobe;
use crate::reference::light::emission::Emission;
use crate::reference::math::finite::is_finite;
use crate::reference::math::frame::{frame_about, to_world};
use crate::reference::math::{Real, Vec3};
use crate::reference::path::blocks::{Origin, path_block};
use crate::reference::path::vertex::self_distance;
use crate::reference::path::{SampleId, Subpath};
use crate::reference::sampler::{camera_block, light_block, unit_float};
use crate::reference::shape::{FAR, Ray, START_OUTSIDE};
use crate::reference::world::World;
use crate::settings::Settings;

/// The first vertex of a light path.
#[derive(Clone, Copy, Debug)]
pub struct LightStart<F> {
    pub point: Emission<F>,
    /// L/(P p_A): radiance over the density of the point among those of all lights.
    pub radiance: Vec3<F>,
    /// P p_A, that density.
    pub pdf: F,
    pub light: usize,
    pub shape: u32,
    pub medium: u32,
}

/// The point where a light path begins; `None` if there is no light, or the choice falls on the background, which sends
/// out none.
pub fn light_start<F: Real>(
    world: &World<F>,
    settings: &Settings,
    id: SampleId,
) -> Option<LightStart<F>> {
    if world.lights.is_empty() {
        return None;
    }
    let u = id.words(settings, path_block(Origin::Light, camera_block()));
    let light = world.light_choice(u[0] >> 8);
    let point = world.light_emission(light, u[1] >> 8, [unit_float(u[2]), unit_float(u[3])]);
    let p = world.light_pmf(light) * point.area_pdf;
    // A broken density breaks the quotient, which the film then drops and counts.
    let shape = world.lights[light].shape;
    let emits =
        (p > F::zero() || !is_finite(p)) && !world.is_covered_at(shape, point.prim, point.p);
    emits.then(|| LightStart {
        point,
        radiance: world.lights[light].radiance / p,
        pdf: p,
        light,
        shape,
        medium: world.light_media[light],
    })
}

/// A ray from that vertex.
pub fn emitted_ray<F: Real>(world: &World<F>, start: &LightStart<F>, d: Vec3<F>) -> Ray<F> {
    let kind = world.shapes[start.shape as usize].kind;
    Ray {
        o: start.point.p,
        t_max: F::new(FAR),
        d,
        shape: start.shape,
        prim: start.point.prim,
        start: START_OUTSIDE,
        t_self: self_distance(kind, start.point.p, start.point.n, d),
        medium: start.medium,
    }
}

/// The path that leaves it: L cos θ/p_e with p_e = P p_A cos θ/π is π L/(P p_A) for any direction. This is kept out of
/// the throughput, so that roulette sees a path that starts with 1.
pub fn begin_light_path<F: Real>(
    world: &World<F>,
    settings: &Settings,
    start: &LightStart<F>,
    id: SampleId,
) -> Subpath<F> {
    let u = id.words(settings, path_block(Origin::Light, light_block(0)));
    let u = [unit_float(u[0]), unit_float(u[1])];
    let d = to_world(frame_about(start.point.n), cosine_lobe(u));
    leaving_path(world, start, d)
}

/// A path that starts along `d`.
pub fn leaving_path<F: Real>(world: &World<F>, start: &LightStart<F>, d: Vec3<F>) -> Subpath<F> {
    Subpath {
        ray: emitted_ray(world, start, d),
        throughput: Vec3::one(),
        eta_scale: F::one(),
        pdf: F::zero(),
        delta: false,
        bounce: 0,
    }
}
