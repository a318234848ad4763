//! A connection of a vertex to a point of one light, before the shadow ray; twin of
//! `shaders/integrator/path/pick/candidate.glsl`.

use crate::reference::bsdf::bsdf_eval;
use crate::reference::light::LightSample;
use crate::reference::math::finite::is_finite;
use crate::reference::math::frame::to_local;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::Subpath;
use crate::reference::path::vertex::{Vertex, same_sides};
use crate::reference::world::World;
use crate::settings::Settings;

/// The weight of light found by a connection; kernels' slot `<connect>`.
pub trait Weigh<F> {
    /// For the point `l` of a light, drawn with density `p` per solid angle, where the BSDF has the density `bsdf_pdf`.
    fn weight(&self, light: usize, l: &LightSample<F>, p: F, bsdf_pdf: F) -> F;
}

/// A point of a light, and its contribution.
#[derive(Clone, Copy, Debug)]
pub struct Candidate<F> {
    pub light: usize,
    /// wi, distance and face of the point.
    pub point: LightSample<F>,
    /// Leads through the surface.
    pub through: bool,
    /// The light that arrives if nothing is in the way; black if the point cannot be seen or the surface does not
    /// scatter its light.
    pub contribution: Vec3<F>,
}

/// The point of `light` that `u24` and `u` draw. `expected` is the average number of points drawn on this light, as
/// given by [`pick_probability`](super::pick_probability).
#[allow(clippy::too_many_arguments, reason = "those of its GLSL twin")]
pub fn candidate<F: Real>(
    world: &World<F>,
    settings: &Settings,
    path: &Subpath<F>,
    v: &Vertex<F>,
    light: usize,
    expected: F,
    u24: u32,
    u: [F; 2],
    weigh: &impl Weigh<F>,
) -> Candidate<F> {
    let l = world.light_sample(light, v.p, u24, u);
    let p = expected * l.pdf;
    let wi = to_local(v.frame, l.wi);
    let mut c = Candidate {
        light,
        point: l,
        through: wi.z < F::zero(),
        contribution: Vec3::zero(),
    };
    // A broken density breaks the contribution, which the film then drops and counts.
    let sampled = (p > F::zero() || !is_finite(p))
        && !world.is_covered_at(world.lights[light].shape, l.prim, v.p + l.wi * l.distance);
    if sampled && same_sides(v.facing, l.wi, wi) {
        let f = bsdf_eval(settings, &v.interaction, wi);
        let weight = weigh.weight(light, &l, p, f.pdf);
        let radiance = world.light_radiance(light, l.prim);
        c.contribution = path.throughput * f.value * radiance * (weight / p);
    }
    c
}
