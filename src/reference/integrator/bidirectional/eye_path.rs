//! The path from the eye: lights that it hits, lights and vertices of the light path that it is joined to.

use super::join::{Joint, join};
use super::partial::{Partial, arrive, from_eye, hit_weight};
use super::reservoir::Reservoir;
use super::to_light::{emission_density, join_light};
use super::{Transport, left_partial};
use crate::prepared::MaterialKind;
use crate::reference::camera::eye_sample;
use crate::reference::integrator::light::LightCounts;
use crate::reference::integrator::path::pick::{pick_normal, pick_probability};
use crate::reference::integrator::path::{PathState, begin_path};
use crate::reference::light::background_light_pdf;
use crate::reference::math::finite::is_black;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::extend::extend;
use crate::reference::path::roulette::LONG_PATH;
use crate::reference::path::trace::extend_ray;
use crate::reference::path::vertex::{Vertex, path_vertex};
use crate::reference::path::{SampleId, depth_reached};

/// Follows the eye path of a sample to its end; returns what it has brought, W·sr⁻¹·m⁻².
pub fn eye_path<F: Real>(
    t: Transport<F>,
    light: &Reservoir<F>,
    id: SampleId,
    counts: &mut LightCounts,
) -> Vec3<F> {
    let mut s = begin_path(t.world, t.settings, id);
    let mut partial = None;
    let mut alive = true;
    while alive {
        let origin = s.path.ray.o;
        let (hit, distance) = extend_ray(t.world, t.settings, &mut s.path, &mut s.rays);
        let Some(hit) = hit else {
            s.radiance += s.path.throughput * background_seen(t, &s, partial, origin);
            break;
        };
        let v = path_vertex(t.world, t.settings, s.path.ray, hit, distance, Vec3::one());
        let wo = -s.path.ray.d;
        let seen = emission_seen(t, &s, partial, &v, origin, distance);
        s.radiance += s.path.throughput * seen;
        let cosine = dot3(wo, v.ng).abs();
        let here = match partial {
            None => from_eye(eye_sample(&t.world.camera, v.p).importance, cosine),
            Some(partial) => arrive(partial, distance, cosine),
        };
        let black = v.interaction.material.kind == MaterialKind::Black;
        s.underflow = is_black(s.path.throughput);
        if black || depth_reached(t.settings, s.path.bounce) || s.underflow {
            break;
        }
        join_light(t, &mut s, &v, wo, here, id);
        let x = Joint {
            v: &v,
            wo,
            carried: s.path.throughput,
            medium: s.path.ray.medium,
            partial: here,
            count: s.path.bounce + 2,
        };
        for (y, share) in light.vertices() {
            if let Some(brought) = join(t, &x, &y.joint(), &mut s.rays) {
                s.radiance += brought * share;
            }
        }
        s.pick_normal = pick_normal(t.world, t.settings, &v);
        let e = extend(t.settings, Origin::Eye, &mut s.path, &v, id);
        s.underflow = e.underflow;
        // A broken throughput breaks the sample, which the film then drops and counts.
        if e.broken {
            s.radiance += s.path.throughput;
        }
        if e.alive {
            partial = Some(left_partial(t, &s.path, &v, wo, here));
        }
        alive = e.alive;
    }
    counts.rays += s.rays;
    counts.long_paths += u64::from(s.path.bounce >= LONG_PATH);
    counts.underflows += u64::from(s.underflow);
    s.radiance
}

/// Weighted radiance of a light that the path has hit.
fn emission_seen<F: Real>(
    t: Transport<F>,
    s: &PathState<F>,
    partial: Option<Partial<F>>,
    v: &Vertex<F>,
    origin: Vec3<F>,
    distance: F,
) -> Vec3<F> {
    let Some(light) = t.world.light_of(v.shape) else {
        return Vec3::zero();
    };
    let weight = partial.map_or(F::one(), |partial| {
        let cosine = dot3(s.path.ray.d, v.ng).abs();
        let expected = pick_probability(t.world, t.settings, light, origin, s.pick_normal);
        let p_n = expected * (t.world).light_pdf(light, origin, v.prim, cosine, distance);
        let emission = emission_density(t, light, origin, v.prim, s.path.ray.d);
        hit_weight(partial, p_n, emission)
    });
    t.world.lights[light].radiance * t.ways.weight(0, s.path.bounce + 2, weight)
}

/// Weighted radiance of everything outside, which sends out no light paths.
fn background_seen<F: Real>(
    t: Transport<F>,
    s: &PathState<F>,
    partial: Option<Partial<F>>,
    origin: Vec3<F>,
) -> Vec3<F> {
    let Some(light) = t.world.background_light else {
        return Vec3::zero();
    };
    let weight = partial.map_or(F::one(), |partial| {
        let expected = pick_probability(t.world, t.settings, light, origin, s.pick_normal);
        hit_weight(partial, expected * background_light_pdf(), F::zero())
    });
    t.world.lights[light].radiance * t.ways.weight(0, s.path.bounce + 2, weight)
}
