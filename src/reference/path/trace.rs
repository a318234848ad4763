//! The rays of a path, through null interfaces; twin of `shaders/path/trace.glsl`.

use super::Subpath;
use super::medium::{stretch_transmittance, term_attenuation};
use super::vertex::self_distance;
use crate::prepared::{MaterialKind, NONE};
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::shape::{Hit, Ray, START_INSIDE, START_OUTSIDE, Target};
use crate::reference::world::World;
use crate::settings::Settings;

/// Traces the extension ray to the next surface that is no null interface, attenuating the throughput on its way.
/// Returns the hit, or `None` if the ray leaves the scene, and the distance from the last vertex.
pub fn extend_ray<F: Real>(
    world: &World<F>,
    settings: &Settings,
    path: &mut Subpath<F>,
    rays: &mut u64,
) -> (Option<Hit<F>>, F) {
    let absorption = settings.model.absorption;
    let mut distance = F::zero();
    loop {
        let hit = world.nearest(path.ray, Target::none());
        *rays += 1;
        path.throughput *= stretch_transmittance(world, absorption, path.ray.medium, hit.t);
        if hit.shape == NONE {
            return (None, distance);
        }
        distance += hit.t;
        if !is_null_interface(world, hit) {
            return (Some(hit), distance);
        }
        let skipped = skip_intersection(world, settings, path.ray, hit);
        path.throughput *= skipped.factor;
        path.ray = skipped.ray;
    }
}

/// A connection to be traced to a point of a light.
#[derive(Clone, Copy, Debug)]
pub struct ShadowRay<F> {
    /// Ends at the point.
    pub ray: Ray<F>,
    /// Does not stop the ray.
    pub target: Target,
    /// The light that arrives if nothing is in its way.
    pub contribution: Vec3<F>,
}

/// The light that arrives over a connection, or `None` if something is in its way.
pub fn shadow_ray<F: Real>(
    world: &World<F>,
    settings: &Settings,
    c: ShadowRay<F>,
    rays: &mut u64,
) -> Option<Vec3<F>> {
    shadow_ray_into(world, settings, c, rays).map(|(light, _)| light)
}

/// The same, and the medium in which the connection ends.
pub fn shadow_ray_into<F: Real>(
    world: &World<F>,
    settings: &Settings,
    mut c: ShadowRay<F>,
    rays: &mut u64,
) -> Option<(Vec3<F>, u32)> {
    let absorption = settings.model.absorption;
    loop {
        let hit = world.obstacle(c.ray, c.target);
        *rays += 1;
        let transmittance = stretch_transmittance(world, absorption, c.ray.medium, hit.t);
        if hit.shape == NONE {
            return Some((c.contribution * transmittance, c.ray.medium));
        }
        if !is_null_interface(world, hit) {
            return None;
        }
        let skipped = skip_intersection(world, settings, c.ray, hit);
        c.contribution *= transmittance * skipped.factor;
        c.ray = skipped.ray;
    }
}

/// Whether the surface is a null interface: |ior − 1| < 1e-7 (model.md, "The null interface").
fn is_null_interface<F: Real>(world: &World<F>, hit: Hit<F>) -> bool {
    let material = world.shapes[hit.shape as usize].material;
    world.materials[material as usize].kind == MaterialKind::NullInterface
}

/// The ray beyond a null interface, and the attenuation that `term` applies on leaving.
struct Skipped<F> {
    ray: Ray<F>,
    factor: Vec3<F>,
}

fn skip_intersection<F: Real>(
    world: &World<F>,
    settings: &Settings,
    ray: Ray<F>,
    hit: Hit<F>,
) -> Skipped<F> {
    let surface = world.hit_surface(ray, hit);
    let shape = &world.shapes[hit.shape as usize];
    let outside = dot3(ray.d, surface.ng) <= F::zero();
    Skipped {
        ray: Ray {
            o: surface.p,
            t_max: ray.t_max - hit.t,
            d: ray.d,
            shape: hit.shape,
            prim: hit.prim,
            start: if outside { START_INSIDE } else { START_OUTSIDE },
            t_self: self_distance(shape.kind, surface.p, surface.ng, ray.d),
            medium: if outside { shape.material } else { NONE },
        },
        factor: term_attenuation(
            world,
            settings.model.absorption,
            shape.material,
            outside,
            hit.t,
        ),
    }
}
