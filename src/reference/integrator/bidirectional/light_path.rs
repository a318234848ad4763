//! The path from a light: its splats, and the vertices that eye paths are joined to.

use super::partial::{Junction, Partial, arrive, from_light, splat_weight};
use super::reservoir::{LightVertex, Reservoir, has_density};
use super::{Transport, left_partial};
use crate::prepared::MaterialKind;
use crate::reference::integrator::light::begin::{LightStart, begin_light_path, light_start};
use crate::reference::integrator::light::splat::{SplatRay, Window, splat_vertex};
use crate::reference::integrator::light::{LightCounts, Splat};
use crate::reference::integrator::path::pick::{pick_normal, pick_probability};
use crate::reference::math::finite::{has_nan, is_black};
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::blocks::{Origin, path_block};
use crate::reference::path::extend::extend;
use crate::reference::path::roulette::LONG_PATH;
use crate::reference::path::trace::{extend_ray, shadow_ray};
use crate::reference::path::vertex::{Vertex, path_vertex, reverse_pdf};
use crate::reference::path::{SampleId, Subpath, depth_reached};
use crate::reference::sampler::{roulette_block, unit_float};

/// Follows the light path of a sample to its end.
pub fn light_path<F: Real>(
    t: Transport<F>,
    window: Window,
    id: SampleId,
    counts: &mut LightCounts,
    take: &mut impl FnMut(Splat<F>),
) -> Reservoir<F> {
    let mut reservoir = Reservoir::empty();
    let Some(start) = light_start(t.world, t.adjoint, id) else {
        return reservoir;
    };
    let mut path = begin_light_path(t.world, t.adjoint, &start, id);
    let power = start.radiance * F::new(std::f64::consts::PI);
    let mut partial = None;
    let mut alive = true;
    while alive {
        let (hit, distance) = extend_ray(t.world, t.adjoint, &mut path, &mut counts.rays);
        let Some(hit) = hit else { break };
        let v = path_vertex(t.world, t.adjoint, path.ray, hit, distance, Vec3::one());
        let wo = -path.ray.d;
        let cosine = dot3(wo, v.ng).abs();
        let here = match partial {
            None => first_partial(t, &start, &v, wo, distance),
            Some(partial) => arrive(partial, distance, cosine),
        };
        let absorbed = is_black(path.throughput);
        counts.underflows += u64::from(absorbed);
        let black = v.interaction.material.kind == MaterialKind::Black;
        if black || depth_reached(t.adjoint, path.bounce) || absorbed {
            break;
        }
        let vertex = LightVertex {
            v,
            wo,
            power: power * path.throughput,
            medium: path.ray.medium,
            partial: here,
            count: path.bounce + 2,
        };
        if has_density(&v.interaction.material) {
            let [.., u] = id.words(
                t.adjoint,
                path_block(Origin::Light, roulette_block(path.bounce)),
            );
            reservoir.offer(vertex, unit_float(u));
        }
        let splat = weighed_splat(t, window, power, &path, &vertex);
        alive = go_on(t, &mut path, &vertex, id, counts, &mut partial);
        if let Some(SplatRay { shadow, pixel, .. }) = splat
            && let Some(value) = shadow_ray(t.world, t.adjoint, shadow, &mut counts.rays)
        {
            take(Splat { value, pixel });
        }
    }
    reservoir
}

/// What the weights know at the first vertex that light arrives at, along `wo`.
fn first_partial<F: Real>(
    t: Transport<F>,
    start: &LightStart<F>,
    v: &Vertex<F>,
    wo: Vec3<F>,
    distance: F,
) -> Partial<F> {
    let LightStart { light, point, .. } = *start;
    let n = pick_normal(t.world, t.settings, v);
    let expected = pick_probability(t.world, t.settings, light, v.p, n);
    let at_light = dot3(wo, point.n).abs();
    let p_n = expected * (t.world).light_pdf(light, v.p, point.prim, at_light, distance);
    let emission = start.pdf * F::new(std::f64::consts::FRAC_1_PI);
    from_light(p_n, emission, dot3(wo, v.ng).abs())
}

/// Moves the path and what the weights know onto the next direction; false where it ends.
fn go_on<F: Real>(
    t: Transport<F>,
    path: &mut Subpath<F>,
    at: &LightVertex<F>,
    id: SampleId,
    counts: &mut LightCounts,
    partial: &mut Option<Partial<F>>,
) -> bool {
    let e = extend(t.adjoint, Origin::Light, path, &at.v, id);
    counts.underflows += u64::from(e.underflow);
    counts.long_paths += u64::from(e.alive && path.bounce == LONG_PATH);
    let nan = e.broken && has_nan(path.throughput);
    counts.nan += u64::from(nan);
    counts.infinite += u64::from(e.broken && !nan);
    if e.alive {
        *partial = Some(left_partial(t, path, &at.v, at.wo, at.partial));
    }
    e.alive
}

/// A vertex joined to the eye.
fn weighed_splat<F: Real>(
    t: Transport<F>,
    window: Window,
    power: Vec3<F>,
    path: &Subpath<F>,
    at: &LightVertex<F>,
) -> Option<SplatRay<F>> {
    let mut splat = splat_vertex(t.world, t.adjoint, window, power, path, &at.v)?;
    let wi = splat.shadow.ray.d;
    let y = Junction {
        cosine: dot3(wi, at.v.ng).abs(),
        pdf: F::zero(),
        reverse_pdf: reverse_pdf(t.settings, &at.v, wi, at.wo),
    };
    let weight = splat_weight(at.partial, y, splat.importance);
    splat.shadow.contribution *= Vec3::splat(t.ways.weight(at.count, 1, weight));
    (!is_black(splat.shadow.contribution)).then_some(splat)
}
