//! Explicit connection of a vertex to a point on a light; twin of `shaders/integrator/path/direct/`.

use super::PathState;
use super::pick::candidate::Candidate;
use super::pick::pick;
use super::record::Recorder;
use crate::reference::math::Real;
use crate::reference::math::finite::is_black;
use crate::reference::path::spawn::spawn_ray;
use crate::reference::path::trace::{ShadowRay, shadow_ray};
use crate::reference::path::vertex::Vertex;
use crate::reference::path::{SampleId, Subpath};
use crate::reference::sampler::light_block;
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
    let u = id.words(settings, light_block(s.path.bounce));
    let weigh = &settings.estimator.connect;
    let Some(c) = pick(world, settings, &s.path, v, u, weigh) else {
        return;
    };
    let Some(shadow) = shadow_to_light(world, &s.path, v, c) else {
        return;
    };
    recorder.light(s, c.light as u32, c.contribution);
    let arrived = shadow_ray(world, settings, shadow, &mut s.rays);
    recorder.connection(s, &shadow, arrived);
    if let Some(light) = arrived {
        s.radiance += light;
    }
}

/// The ray from a vertex to a point of a light that looks for occluders; `None` where the point contributes nothing.
pub fn shadow_to_light<F: Real>(
    world: &World<F>,
    path: &Subpath<F>,
    v: &Vertex<F>,
    c: Candidate<F>,
) -> Option<ShadowRay<F>> {
    if is_black(c.contribution) {
        return None;
    }
    let ray = spawn_ray(v, c.point.wi, c.through, path.ray.medium);
    Some(ShadowRay {
        ray: Ray {
            t_max: if c.point.distance < F::zero() {
                F::new(FAR)
            } else {
                c.point.distance
            },
            ..ray
        },
        target: Target {
            shape: world.lights[c.light].shape,
            prim: c.point.prim,
        },
        contribution: c.contribution,
    })
}
