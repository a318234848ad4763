//! The path from a light: its splats, and the vertices to which eye paths are joined.

use super::Transport;
use super::aim::{aimed_density, aimed_direction};
use super::bend::{bend, left_partial};
use super::joint::Joint;
use super::partial::{Partial, arrive, from_light_point, splat_weight};
use super::record::{Far, Recorder};
use super::reservoir::{Reservoir, has_density};
use crate::prepared::MaterialKind;
use crate::reference::bsdf::LOBE_NONE;
use crate::reference::camera::eye_drawn;
use crate::reference::integrator::light::begin::{LightStart, leaving_path, light_start};
use crate::reference::integrator::light::splat::{SplatRay, Window, in_film, splat_ray};
use crate::reference::integrator::light::{LightCounts, Splat, count_extension};
use crate::reference::integrator::path::pick::{pick_normal, pick_probability};
use crate::reference::light::emission::Emission;
use crate::reference::math::finite::is_black;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::blocks::{Origin, path_block};
use crate::reference::path::extend::extend;
use crate::reference::path::spawn::spawn_ray;
use crate::reference::path::trace::{extend_ray, shadow_ray};
use crate::reference::path::vertex::{Vertex, path_vertex};
use crate::reference::path::{SampleId, Subpath, depth_reached};
use crate::reference::sampler::{light_block, roulette_block, unit_float};

/// Follows the light path of a sample to its end.
pub fn light_path<F: Real>(
    t: Transport<F>,
    window: Window,
    id: SampleId,
    counts: &mut LightCounts,
    recorder: &mut impl Recorder<F>,
    take: &mut impl FnMut(Splat<F>),
) -> Reservoir<F> {
    let mut reservoir = Reservoir::empty();
    let Some(start) = light_start(t.world, t.adjoint, id) else {
        return reservoir;
    };
    let (mut path, density) = begin_aimed_path(t, &start, id);
    // L cos θ/p_e, p_e = P p_A p: `radiance` is L/(P p_A), `density` p/cos θ.
    let power = start.radiance / density;
    let mut partial = None;
    // Half the cone of an aim may be behind the light.
    let mut alive = dot3(path.ray.d, start.point.n) > F::zero();
    if alive {
        recorder.start(&start, &path, power);
    }
    while alive {
        let (hit, distance) = extend_ray(t.world, t.adjoint, &mut path, &mut counts.rays);
        let Some(hit) = hit else {
            recorder.escape(Origin::Light, &path);
            break;
        };
        let v = path_vertex(t.world, t.adjoint, path.ray, hit, distance, Vec3::one());
        let wo = -path.ray.d;
        let cosine = dot3(wo, v.ng).abs();
        let here = match partial {
            None => first_partial(t, &start, density, &v, wo, distance),
            Some(partial) => arrive(partial, distance, cosine),
        };
        let y = Joint {
            v,
            wo,
            carried: power * path.throughput,
            medium: path.ray.medium,
            partial: here,
            count: path.bounce + 2,
        };
        recorder.hit(Origin::Light, &y);
        let absorbed = is_black(path.throughput);
        counts.underflows += u64::from(absorbed);
        let black = v.interaction.material.kind == MaterialKind::Black;
        if black || depth_reached(t.adjoint, path.bounce) || absorbed {
            recorder.scattered(Origin::Light, &path, LOBE_NONE);
            break;
        }
        let material = &v.interaction.material;
        if has_density(material.kind, material.kd) {
            let [.., u] = id.words(
                t.adjoint,
                path_block(Origin::Light, roulette_block(path.bounce)),
            );
            reservoir.offer(y, unit_float(u));
        }
        let splat = weighed_splat(t, window, &y, id);
        let e = extend(t.adjoint, Origin::Light, &mut path, &v, id);
        count_extension(&path, e, counts);
        if e.alive {
            partial = Some(left_partial(t.adjoint, &path, &v, wo, here));
        }
        alive = e.alive;
        if let Some(SplatRay { shadow, pixel, .. }) = splat {
            let point = shadow.ray.o + shadow.ray.d * shadow.ray.t_max;
            let arrived = shadow_ray(t.world, t.adjoint, shadow, &mut counts.rays);
            recorder.connection(Far::Eye { pixel, point }, arrived);
            arrived
                .into_iter()
                .for_each(|value| take(Splat { value, pixel }));
        }
        recorder.scattered(Origin::Light, &path, e.lobe);
    }
    reservoir
}

/// The path that leaves a light, and its direction's density over its cosine there.
fn begin_aimed_path<F: Real>(
    t: Transport<F>,
    start: &LightStart<F>,
    id: SampleId,
) -> (Subpath<F>, F) {
    let u = id.words(t.adjoint, path_block(Origin::Light, light_block(0)));
    let [x, y, choice, _] = u.map(unit_float);
    let Emission { p, n, .. } = start.point;
    let d = aimed_direction(&t.world.aims, p, n, choice, [x, y]);
    let density = aimed_density(&t.world.aims, p, d, dot3(d, n));
    (leaving_path(t.world, start, d), density)
}

/// The quantities of the weights at the first vertex that light reaches, along `wo`.
fn first_partial<F: Real>(
    t: Transport<F>,
    start: &LightStart<F>,
    density: F,
    v: &Vertex<F>,
    wo: Vec3<F>,
    distance: F,
) -> Partial<F> {
    let LightStart { light, point, .. } = *start;
    let n = pick_normal(t.world, t.settings, v);
    let expected = pick_probability(t.world, t.settings, light, v.p, n);
    let at_light = dot3(wo, point.n).abs();
    let p_n = expected * (t.world).light_pdf(light, v.p, point.prim, at_light, distance);
    let emission = start.pdf * density;
    from_light_point(p_n, emission, dot3(wo, v.ng).abs())
}

/// A vertex joined to the eye.
fn weighed_splat<F: Real>(
    t: Transport<F>,
    window: Window,
    y: &Joint<F>,
    id: SampleId,
) -> Option<SplatRay<F>> {
    let eye = eye_drawn(t.world, t.adjoint, id, light_block(y.count - 1), y.v.p);
    if !in_film(window, &eye) {
        return None;
    }
    let at = bend(t.adjoint, Origin::Light, &y.v, y.wo, eye.wi)?;
    let weight = splat_weight(y.partial, at.junction, eye.importance);
    let weight = t.ways.weight(y.count, 1, weight);
    let contribution = y.carried * at.f * eye.importance * Vec3::splat(weight);
    let ray = spawn_ray(&y.v, eye.wi, at.through, y.medium);
    splat_ray(t.world, window, eye, ray, contribution)
}
