//! The path from the eye: lights that it hits, lights and vertices of the light path to which it is joined.

use super::Transport;
use super::bend::left_partial;
use super::join::{Connection, join};
use super::joint::Joint;
use super::partial::{Partial, arrive, from_eye, hit_weight};
use super::record::{Far, Recorder};
use super::reservoir::Reservoir;
use super::to_light::{emission_density, join_light};
use crate::prepared::MaterialKind;
use crate::reference::bsdf::LOBE_NONE;
use crate::reference::camera::eye_importance;
use crate::reference::integrator::light::LightCounts;
use crate::reference::integrator::path::pick::{pick_normal, pick_probability};
use crate::reference::integrator::path::{PathState, begin_path};
use crate::reference::math::finite::is_black;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::extend::extend;
use crate::reference::path::roulette::LONG_PATH;
use crate::reference::path::trace::{extend_ray, shadow_ray, shadow_ray_into};
use crate::reference::path::vertex::{Vertex, path_vertex};
use crate::reference::path::{SampleId, Subpath, depth_reached};

/// Follows the eye path of a sample to its end; returns its radiance, W·sr⁻¹·m⁻².
pub fn eye_path<F: Real>(
    t: Transport<F>,
    light: &Reservoir<F>,
    id: SampleId,
    counts: &mut LightCounts,
    recorder: &mut impl Recorder<F>,
) -> Vec3<F> {
    let mut s = begin_path(t.world, t.settings, id);
    recorder.looks(&s.path);
    let mut partial = None;
    let mut alive = true;
    while alive {
        let origin = s.path.ray.o;
        let (hit, distance) = extend_ray(t.world, t.settings, &mut s.path, &mut s.rays);
        let Some(hit) = hit else {
            let seen = background_seen(t, &s.path, partial, s.pick_normal, origin);
            let seen = s.path.throughput * seen;
            recorder.emission(None, &s.path, seen);
            s.radiance += seen;
            recorder.escape(Origin::Eye, &s.path);
            break;
        };
        let v = path_vertex(t.world, t.settings, s.path.ray, hit, distance, Vec3::one());
        let wo = -s.path.ray.d;
        let cosine = dot3(wo, v.ng).abs();
        let here = match partial {
            None => from_eye(eye_importance(&t.world.camera, v.p - origin), cosine),
            Some(partial) => arrive(partial, distance, cosine),
        };
        let x = Joint {
            v,
            wo,
            carried: s.path.throughput,
            medium: s.path.ray.medium,
            partial: here,
            count: s.path.bounce + 2,
        };
        recorder.hit(Origin::Eye, &x);
        let n = s.pick_normal;
        let seen = emission_seen(t, &s.path, partial, n, &v, origin, distance);
        let seen = s.path.throughput * seen;
        recorder.emission(Some(&x), &s.path, seen);
        s.radiance += seen;
        let black = v.interaction.material.kind == MaterialKind::Black;
        s.underflow = is_black(s.path.throughput);
        if black || depth_reached(t.settings, s.path.bounce) || s.underflow {
            recorder.scattered(Origin::Eye, &s.path, LOBE_NONE);
            break;
        }
        connections(t, &mut s, &x, light, id, recorder);
        s.pick_normal = pick_normal(t.world, t.settings, &v);
        let e = extend(t.settings, Origin::Eye, &mut s.path, &v, id);
        s.underflow = e.underflow;
        // A broken throughput breaks the sample, which the film then drops and counts.
        if e.broken {
            s.radiance += s.path.throughput;
        }
        recorder.scattered(Origin::Eye, &s.path, e.lobe);
        if e.alive {
            partial = Some(left_partial(t.settings, &s.path, &v, wo, here));
        }
        alive = e.alive;
    }
    counts.rays += s.rays;
    counts.long_paths += u64::from(s.path.bounce >= LONG_PATH);
    counts.underflows += u64::from(s.underflow);
    s.radiance
}

/// Adds the connections of a vertex to a light and to the kept vertices of the light path.
fn connections<F: Real>(
    t: Transport<F>,
    s: &mut PathState<F>,
    x: &Joint<F>,
    light: &Reservoir<F>,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
) {
    if let Some((candidate, shadow)) = join_light(t, &s.path, &x.v, x.partial, id) {
        recorder.light(candidate.light as u32, candidate.contribution);
        let arrived = shadow_ray(t.world, t.settings, shadow, &mut s.rays);
        recorder.connection(Far::Light(&candidate), arrived);
        s.radiance += arrived.unwrap_or(Vec3::zero());
    }
    for (y, share) in light.vertices() {
        if let Some(c) = join(t, x, y, share) {
            let arrived = arrives(t, c, &mut s.rays);
            recorder.connection(Far::Vertex(y), arrived);
            s.radiance += arrived.unwrap_or(Vec3::zero());
        }
    }
}

/// The light that arrives over a connection of two vertices: `None` where it ends in another medium than it must.
fn arrives<F: Real>(t: Transport<F>, c: Connection<F>, rays: &mut u64) -> Option<Vec3<F>> {
    let (light, medium) = shadow_ray_into(t.world, t.settings, c.shadow, rays)?;
    (medium == c.medium).then_some(light)
}

/// Weighted radiance of a light that the path has hit; `n` is the last vertex's [`pick_normal`].
fn emission_seen<F: Real>(
    t: Transport<F>,
    path: &Subpath<F>,
    partial: Option<Partial<F>>,
    n: Vec3<F>,
    v: &Vertex<F>,
    origin: Vec3<F>,
    distance: F,
) -> Vec3<F> {
    let Some(light) = t.world.light_of(v.shape) else {
        return Vec3::zero();
    };
    let weight = partial.map_or(F::one(), |partial| {
        let cosine = dot3(path.ray.d, v.ng).abs();
        let expected = pick_probability(t.world, t.settings, light, origin, n);
        let p_n = expected * (t.world).light_pdf(light, origin, v.prim, cosine, distance);
        let emission = emission_density(t, light, origin, v.prim, path.ray.d, v.p, cosine);
        hit_weight(partial, p_n, emission)
    });
    t.world.lights[light].radiance * t.ways.weight(0, path.bounce + 2, weight)
}

/// Weighted radiance of the surroundings, which send out no light paths.
fn background_seen<F: Real>(
    t: Transport<F>,
    path: &Subpath<F>,
    partial: Option<Partial<F>>,
    n: Vec3<F>,
    origin: Vec3<F>,
) -> Vec3<F> {
    let Some(light) = t.world.background_light else {
        return Vec3::zero();
    };
    let outside = t.world.outside_seen(light, path.ray.d);
    let weight = partial.map_or(F::one(), |partial| {
        let expected = pick_probability(t.world, t.settings, light, origin, n);
        hit_weight(partial, expected * outside.pdf, F::zero())
    });
    outside.radiance * t.ways.weight(0, path.bounce + 2, weight)
}
