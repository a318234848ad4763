//! A vertex of a light path joined to the eye: the light that arrives is a splat on the pixel that sees the vertex.
//! Twin of `shaders/integrator/light/splat.glsl`.

use super::begin::{LightStart, emitted_ray};
use crate::reference::bsdf::bsdf_eval;
use crate::reference::camera::{EyeSample, eye_drawn};
use crate::reference::math::finite::is_black;
use crate::reference::math::frame::to_local;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::correction::corrected;
use crate::reference::path::spawn::spawn_ray;
use crate::reference::path::trace::ShadowRay;
use crate::reference::path::vertex::{Vertex, same_sides};
use crate::reference::path::{SampleId, Subpath};
use crate::reference::sampler::light_block;
use crate::reference::shape::{Ray, Target};
use crate::reference::world::World;
use crate::settings::Settings;

/// Light on its way to a pixel.
#[derive(Clone, Copy, Debug)]
pub struct SplatRay<F> {
    pub shadow: ShadowRay<F>,
    /// row · width + column of the full picture.
    pub pixel: u32,
}

/// The pixels that are rendered, from the top left of the full picture.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    pub x: u32,
    pub y: u32,
    pub width: u32,
    pub height: u32,
}

/// Whether a pixel is rendered.
pub fn in_film<F: Real>(window: Window, eye: &EyeSample<F>) -> bool {
    let x = eye.column.wrapping_sub(window.x);
    let y = eye.row.wrapping_sub(window.y);
    eye.seen && x < window.width && y < window.height
}

/// A connection along `ray`, unless it contributes nothing or the eye does not see the vertex.
pub fn splat_ray<F: Real>(
    world: &World<F>,
    window: Window,
    eye: EyeSample<F>,
    ray: Ray<F>,
    contribution: Vec3<F>,
) -> Option<SplatRay<F>> {
    let pending = in_film(window, &eye) && !is_black(contribution);
    pending.then(|| SplatRay {
        shadow: ShadowRay {
            ray: Ray {
                t_max: eye.distance,
                ..ray
            },
            target: Target::none(),
            contribution,
        },
        pixel: eye.row * world.width + eye.column,
    })
}

/// The light itself, as the eye sees it: L cos θ W/(P p_A).
pub fn splat_light<F: Real>(
    world: &World<F>,
    settings: &Settings,
    window: Window,
    start: &LightStart<F>,
    id: SampleId,
) -> Option<SplatRay<F>> {
    let eye = eye_drawn(world, settings, id, light_block(0), start.point.p);
    let cosine = dot3(start.point.n, eye.wi);
    let contribution = start.radiance * (cosine * eye.importance);
    let ray = emitted_ray(world, start, eye.wi);
    let seen = cosine > F::zero();
    splat_ray(world, window, eye, ray, contribution).filter(|_| seen)
}

/// A vertex that scatters: `power` · throughput · f · W, f = value·|N·wi| of the adjoint.
pub fn splat_vertex<F: Real>(
    world: &World<F>,
    settings: &Settings,
    window: Window,
    power: Vec3<F>,
    path: &Subpath<F>,
    v: &Vertex<F>,
    id: SampleId,
) -> Option<SplatRay<F>> {
    let eye = eye_drawn(world, settings, id, light_block(path.bounce + 1), v.p);
    let wi = to_local(v.frame, eye.wi);
    let value = bsdf_eval(settings, &v.interaction, wi).value;
    let f = corrected(Origin::Light, v, eye.wi, wi, value);
    let contribution = power * path.throughput * f * eye.importance;
    let ray = spawn_ray(v, eye.wi, wi.z < F::zero(), path.ray.medium);
    let valid = same_sides(v.facing, eye.wi, wi);
    splat_ray(world, window, eye, ray, contribution).filter(|_| valid)
}
