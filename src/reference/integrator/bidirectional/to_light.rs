//! A vertex of the eye path connected to a light.

use super::Transport;
use super::partial::{Junction, Partial, light_weight};
use crate::reference::integrator::path::PathState;
use crate::reference::integrator::path::direct::shadow_to_light;
use crate::reference::integrator::path::pick::candidate::Weigh;
use crate::reference::integrator::path::record::Silent;
use crate::reference::light::LightSample;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::SampleId;
use crate::reference::path::trace::shadow_ray;
use crate::reference::path::vertex::{Vertex, reverse_pdf};

/// Density per area and solid angle of the start of a light path that `p` sees along `wi`, over the cosine there: P p_A/π.
pub fn emission_density<F: Real>(
    t: Transport<F>,
    light: usize,
    p: Vec3<F>,
    prim: u32,
    wi: Vec3<F>,
) -> F {
    let per_area = t.world.emission_pdf(light, p, prim, wi);
    t.world.light_pmf(light) * per_area * F::new(std::f64::consts::FRAC_1_PI)
}

/// What weighs a connection of an eye path's vertex to a light.
struct ToLight<'a, F> {
    t: Transport<'a, F>,
    v: &'a Vertex<F>,
    wo: Vec3<F>,
    partial: Partial<F>,
    count: u32,
}

impl<F: Real> Weigh<F> for ToLight<'_, F> {
    fn weight(&self, light: usize, l: &LightSample<F>, p: F, bsdf_pdf: F) -> F {
        let Self { t, v, .. } = *self;
        let x = Junction {
            cosine: dot3(l.wi, v.ng).abs(),
            pdf: bsdf_pdf,
            reverse_pdf: reverse_pdf(t.settings, v, l.wi, self.wo),
        };
        let emission = emission_density(t, light, v.p, l.prim, l.wi);
        let weight = light_weight(self.partial, x, p, emission);
        t.ways.weight(1, self.count, weight)
    }
}

/// Adds the light of one connection to a light.
pub fn join_light<F: Real>(
    t: Transport<F>,
    s: &mut PathState<F>,
    v: &Vertex<F>,
    wo: Vec3<F>,
    partial: Partial<F>,
    id: SampleId,
) {
    if t.world.lights.is_empty() {
        return;
    }
    let weigh = ToLight {
        t,
        v,
        wo,
        partial,
        count: s.path.bounce + 2,
    };
    let shadow = shadow_to_light(t.world, t.settings, s, v, id, &weigh, &mut Silent);
    let arrived = shadow.and_then(|c| shadow_ray(t.world, t.settings, c, &mut s.rays));
    if let Some(light) = arrived {
        s.radiance += light;
    }
}
