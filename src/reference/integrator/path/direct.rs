//! Explicit connection of a vertex to a point on a light; twin of `shaders/integrator/path/direct/`.

use super::PathState;
use super::connect::connection_weight;
use super::record::Recorder;
use crate::reference::bsdf::bsdf_eval;
use crate::reference::math::Real;
use crate::reference::math::finite::{is_black, is_finite};
use crate::reference::math::frame::to_local;
use crate::reference::path::SampleId;
use crate::reference::path::spawn::spawn_ray;
use crate::reference::path::trace::{ShadowRay, shadow_ray};
use crate::reference::path::vertex::{Vertex, same_sides};
use crate::reference::sampler::{light_block, unit_float};
use crate::reference::shape::{FAR, Ray, Target};
use crate::reference::world::World;
use crate::settings::{Connect, Settings};

/// Adds the light of one connection. Comes before roulette, which scales only the extension (model.md, "Roulette").
pub fn connect<F: Real>(
    world: &World<F>,
    settings: &Settings,
    s: &mut PathState<F>,
    v: &Vertex<F>,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
) {
    if world.lights.is_empty() || settings.estimator.connect == Connect::Bsdf {
        return;
    }
    let Some(c) = shadow_to_light(world, settings, s, v, id, recorder) else {
        return;
    };
    let arrived = shadow_ray(world, settings, c, &mut s.rays);
    recorder.connection(s, &c, arrived);
    if let Some(light) = arrived {
        s.radiance += light;
    }
}

fn shadow_to_light<F: Real>(
    world: &World<F>,
    settings: &Settings,
    s: &PathState<F>,
    v: &Vertex<F>,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
) -> Option<ShadowRay<F>> {
    let u = id.words(settings, light_block(s.path.bounce));
    let light = world.light_choice(u[0] >> 8);
    recorder.light(s, light);
    let l = world.light_sample(light, v.p, u[1] >> 8, [unit_float(u[2]), unit_float(u[3])]);
    let p = world.light_pmf(light) * l.pdf;
    let wi = to_local(v.frame, l.wi);
    // A broken density breaks the contribution, which the film then drops and counts.
    let sampled = (p > F::zero() || !is_finite(p))
        && !world.is_covered_at(world.lights[light].shape, l.prim, v.p + l.wi * l.distance);
    if !(sampled && same_sides(v, l.wi, wi)) {
        return None;
    }
    let f = bsdf_eval(settings, &v.interaction, wi);
    let weight = connection_weight(settings.estimator.connect, p, f.pdf);
    let contribution = s.path.throughput * f.value * world.lights[light].radiance * (weight / p);
    let ray = spawn_ray(v, l.wi, wi.z < F::zero(), s.path.ray.medium);
    (!is_black(contribution)).then(|| ShadowRay {
        ray: Ray {
            t_max: if l.distance < F::zero() {
                F::new(FAR)
            } else {
                l.distance
            },
            ..ray
        },
        target: Target {
            shape: world.lights[light].shape,
            prim: l.prim,
        },
        contribution,
    })
}
