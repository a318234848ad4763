//! Explicit connection of a vertex to a point on a light; twin of `shaders/integrator/path/direct/`.

use super::PathState;
use super::pick::candidate::Weigh;
use super::pick::pick;
use super::record::Recorder;
use crate::reference::math::Real;
use crate::reference::math::finite::is_black;
use crate::reference::path::SampleId;
use crate::reference::path::spawn::spawn_ray;
use crate::reference::path::trace::{ShadowRay, shadow_ray};
use crate::reference::path::vertex::Vertex;
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
    let weigh = &settings.estimator.connect;
    let Some(c) = shadow_to_light(world, settings, s, v, id, weigh, recorder) else {
        return;
    };
    let arrived = shadow_ray(world, settings, c, &mut s.rays);
    recorder.connection(s, &c, arrived);
    if let Some(light) = arrived {
        s.radiance += light;
    }
}

/// The connection to a light that the sampler's numbers pick, before anyone has looked for what stands between.
pub fn shadow_to_light<F: Real>(
    world: &World<F>,
    settings: &Settings,
    s: &PathState<F>,
    v: &Vertex<F>,
    id: SampleId,
    weigh: &impl Weigh<F>,
    recorder: &mut impl Recorder<F>,
) -> Option<ShadowRay<F>> {
    let u = id.words(settings, light_block(s.path.bounce));
    let picked = pick(world, settings, &s.path, v, u, weigh);
    let c = picked.filter(|c| !is_black(c.contribution))?;
    recorder.light(s, c.light as u32, c.contribution);
    let ray = spawn_ray(v, c.point.wi, c.through, s.path.ray.medium);
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
