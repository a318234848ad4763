//! The first surfaces that a camera ray sees, for the layers of `--aov`.

use super::bidirectional::reservoir::has_density;
use super::path::begin_path;
use crate::prepared::MaterialKind;
use crate::reference::bsdf::Material;
use crate::reference::math::{Real, Vec3, dot3, max2, min2, vec3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::extend::extend;
use crate::reference::path::trace::extend_ray;
use crate::reference::path::vertex::{Vertex, path_vertex};
use crate::reference::path::{SampleId, depth_reached};
use crate::reference::world::World;
use crate::settings::{Roulette, Settings};

/// The most mirrors and smooth interfaces that a ray is followed through.
const THROUGH: u32 = 32;

/// Where a camera ray has hit something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct First<F> {
    /// Along the direction of view, from the eye; rendering space.
    pub depth: F,
    /// Rendering space.
    pub p: Vec3<F>,
    /// Geometric normal on the eye's side, of unit length.
    pub n: Vec3<F>,
    /// Shading normal there.
    pub ns: Vec3<F>,
    pub shape: u32,
    pub material: u32,
}

/// The surfaces that one sample sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen<F> {
    pub first: Option<First<F>>,
    /// Of the first hit, or the colour of the background; in [0, 1].
    pub albedo: Vec3<F>,
    /// Behind mirrors and smooth glass: of the first surface that scatters, times the light that they pass on.
    pub albedo_behind: Vec3<F>,
    /// Shading normal there; zero if there is no such surface.
    pub ns_behind: Vec3<F>,
}

/// The first surfaces of one sample of a pixel: along the camera ray of its path, and, from mirrors and smooth glass
/// on, along the directions that its path takes there.
pub fn first_seen<F: Real>(world: &World<F>, settings: &Settings, id: SampleId) -> Seen<F> {
    let settings = undisturbed(settings);
    let mut path = begin_path(world, &settings, id).path;
    let mut seen = Seen {
        first: None,
        albedo: Vec3::zero(),
        albedo_behind: Vec3::zero(),
        ns_behind: Vec3::zero(),
    };
    let mut rays = 0;
    for bounce in 0..THROUGH {
        let (hit, distance) = extend_ray(world, &settings, &mut path, &mut rays);
        let Some(hit) = hit else {
            let colour = background_colour(world, path.ray.d);
            seen.albedo = if bounce == 0 { colour } else { seen.albedo };
            seen.albedo_behind = clamped(path.throughput * colour);
            break;
        };
        let v = path_vertex(world, &settings, path.ray, hit, distance, Vec3::one());
        let own = albedo(world, &v);
        if bounce == 0 {
            seen.albedo = own;
            seen.first = Some(first(world, &v));
        }
        let material = &v.interaction.material;
        let scatters =
            has_density(material.kind, material.kd) || material.kind == MaterialKind::Black;
        if scatters || depth_reached(&settings, path.bounce) {
            seen.albedo_behind = clamped(path.throughput * own);
            seen.ns_behind = v.frame.n;
            break;
        }
        if !extend(&settings, Origin::Eye, &mut path, &v, id).alive {
            break;
        }
    }
    seen
}

/// Roulette would add noise, and radiance that is scaled at each refraction is no albedo.
fn undisturbed(settings: &Settings) -> Settings {
    let mut settings = *settings;
    settings.estimator.roulette = Roulette::Off;
    settings.model.radiance_scaling = false;
    settings
}

fn first<F: Real>(world: &World<F>, v: &Vertex<F>) -> First<F> {
    First {
        depth: dot3(v.p - world.camera.eye, world.camera.forward),
        p: v.p,
        n: v.facing,
        ns: v.frame.n,
        shape: v.shape,
        material: v.material,
    }
}

/// Kd + Ks + the transmitted share, 1 − Ks, of a surface; for a light its colour, whose largest channel is 1.
fn albedo<F: Real>(world: &World<F>, v: &Vertex<F>) -> Vec3<F> {
    let m = &v.interaction.material;
    match world.light_of(v.shape) {
        Some(light) => colour(world.lights[light].radiance),
        None => clamped(m.kd + specular(m)),
    }
}

fn specular<F: Real>(m: &Material<F>) -> Vec3<F> {
    match m.kind {
        MaterialKind::Black | MaterialKind::Diffuse => Vec3::zero(),
        MaterialKind::Glossy | MaterialKind::Mirror => m.f0,
        MaterialKind::RoughDielectric
        | MaterialKind::SmoothDielectric
        | MaterialKind::WeakDielectric
        | MaterialKind::NullInterface => Vec3::one(),
    }
}

/// The surroundings' colour along `d`: their radiance up to 1.
fn background_colour<F: Real>(world: &World<F>, d: Vec3<F>) -> Vec3<F> {
    match world.background_light {
        None => Vec3::zero(),
        Some(light) => clamped(world.outside_seen(light, d).radiance),
    }
}

/// A radiance over its largest channel.
fn colour<F: Real>(radiance: Vec3<F>) -> Vec3<F> {
    let most = max2(max2(radiance.x, radiance.y), radiance.z);
    radiance / if most > F::zero() { most } else { F::one() }
}

fn clamped<F: Real>(v: Vec3<F>) -> Vec3<F> {
    let one = F::one();
    vec3(min2(v.x, one), min2(v.y, one), min2(v.z, one))
}
