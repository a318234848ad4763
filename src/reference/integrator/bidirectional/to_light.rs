//! A vertex of the eye path connected to a light.

use super::Transport;
use super::aim::aimed_density;
use super::bend::reverse_pdf;
use super::partial::{Junction, Partial, light_weight};
use crate::reference::integrator::path::direct::shadow_to_light;
use crate::reference::integrator::path::pick::candidate::{Candidate, Weigh};
use crate::reference::integrator::path::pick::pick;
use crate::reference::light::LightSample;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::trace::ShadowRay;
use crate::reference::path::vertex::Vertex;
use crate::reference::path::{SampleId, Subpath};
use crate::reference::sampler::light_block;

/// Density per area and solid angle of the start of a light path at `q`, a point of primitive `prim` that `p` sees along `wi`,
/// over the cosine there: P p_A p/cos.
pub fn emission_density<F: Real>(
    t: Transport<F>,
    light: usize,
    p: Vec3<F>,
    prim: u32,
    wi: Vec3<F>,
    q: Vec3<F>,
    cosine: F,
) -> F {
    let per_area = t.world.emission_pdf(light, p, prim, wi);
    t.world.light_pmf(light) * per_area * aimed_density(&t.world.aims, q, -wi, cosine)
}

/// The weight of a connection from an eye path's vertex to a light.
struct ToLight<'a, F> {
    t: Transport<'a, F>,
    path: &'a Subpath<F>,
    v: &'a Vertex<F>,
    partial: Partial<F>,
}

impl<F: Real> Weigh<F> for ToLight<'_, F> {
    fn weight(&self, light: usize, l: &LightSample<F>, p: F, bsdf_pdf: F) -> F {
        let Self { t, path, v, .. } = *self;
        let x = Junction {
            cosine: dot3(l.wi, v.ng).abs(),
            pdf: bsdf_pdf,
            reverse_pdf: reverse_pdf(t.settings, v, l.wi, -path.ray.d),
        };
        let emission = emission_density(
            t,
            light,
            v.p,
            l.prim,
            l.wi,
            v.p + l.wi * l.distance,
            l.cosine,
        );
        let weight = light_weight(self.partial, x, p, emission);
        t.ways.weight(1, path.bounce + 2, weight)
    }
}

/// A vertex of the eye path, whose ray `path` still is, connected to a point of a light.
pub fn join_light<F: Real>(
    t: Transport<F>,
    path: &Subpath<F>,
    v: &Vertex<F>,
    partial: Partial<F>,
    id: SampleId,
) -> Option<(Candidate<F>, ShadowRay<F>)> {
    if t.world.lights.is_empty() {
        return None;
    }
    let weigh = ToLight {
        t,
        path,
        v,
        partial,
    };
    let u = id.words(t.settings, light_block(path.bounce));
    let picked = pick(t.world, t.settings, path, v, u, &weigh)?;
    let shadow = shadow_to_light(t.world, path, v, picked)?;
    Some((picked, shadow))
}
