//! A prepared scene in the scalar of the reference: the data that kernels read from buffers.

use super::accel::Accel;
use super::bsdf::Material;
use super::camera::{Camera, Lens};
use super::light::emission::Emission;
use super::light::surroundings::surroundings_radiance;
use super::light::tree::LightNode;
use super::light::{
    LightSample, Outside, Surroundings, background_light_sample, background_outside, cdf_choice,
    cdf_probability, surroundings_light_sample, surroundings_outside,
};
use super::math::{Real, Vec3};
pub use super::primitives::Light;
use super::primitives::Primitives;
use super::shape::cover::{is_covered_at, touching};
use super::shape::{Hit, Ray, Surface, Target, no_hit};
pub use crate::prepared::record::aim::scalar::Aim;
use crate::prepared::{LightKind, MaterialKind, NONE, Prepared, Shape};

/// The scene in which paths travel.
pub struct World<F> {
    pub width: u32,
    pub camera: Camera<F>,
    /// `None` for a pinhole.
    pub lens: Option<Lens<F>>,
    pub eye_medium: u32,
    pub shapes: Vec<Shape>,
    pub primitives: Primitives<F>,
    pub materials: Vec<Material<F>>,
    pub lights: Vec<Light<F>>,
    /// Index of the background among the lights, if it emits.
    pub background_light: Option<usize>,
    /// The picture of the surroundings, if the scene has one.
    pub surroundings: Option<Surroundings<F>>,
    /// For each light, the material in which it lies, or `NONE`.
    pub light_media: Vec<u32>,
    /// The balls at which light paths of bidirectional path tracing are aimed.
    pub aims: Vec<Aim<F>>,
    light_cdf: Vec<u32>,
    /// The tree of lights, and the ways to them.
    pub light_nodes: Vec<LightNode<F>>,
    pub light_trails: Vec<u32>,
    triangle_cdf: Vec<u32>,
    /// Whether any surface is a null interface.
    null_interfaces: bool,
    /// The hierarchy over all primitives, if a loop over them would be slower.
    accel: Option<Accel<F>>,
}

/// Up to this many primitives are searched one by one; beyond, the hierarchy is faster for every kind of primitive
/// (`docs/records/2026-11-22-reference-search.md`).
const LINEAR_PRIMITIVES: usize = 16;

impl<F: Real> World<F> {
    /// Each number of `prepared` rounded to the scalar.
    pub fn new(prepared: &Prepared) -> Self {
        let primitives = Primitives::new(&prepared.primitives);
        let (materials, lights) = (prepared.materials.iter(), prepared.lights.iter());
        let nodes = prepared.light_tree.nodes.iter();
        Self {
            width: prepared.camera.width,
            camera: Camera::rounded(&prepared.camera, F::new),
            lens: (prepared.lens.as_ref()).map(|lens| Lens::rounded(lens, F::new)),
            eye_medium: prepared.eye_medium,
            shapes: prepared.shapes.clone(),
            materials: materials.map(|m| Material::rounded(m, F::new)).collect(),
            background_light: lights.clone().position(|l| l.kind.is_outside()),
            surroundings: prepared.surroundings.as_ref().map(Surroundings::new),
            lights: lights.map(|l| Light::rounded(l, F::new)).collect(),
            light_media: prepared.light_media.clone(),
            aims: (prepared.aims.iter())
                .map(|aim| Aim::rounded(aim, F::new))
                .collect(),
            light_cdf: prepared.light_cdf.clone(),
            light_nodes: nodes.map(|n| LightNode::rounded(n, F::new)).collect(),
            light_trails: prepared.light_tree.trails.clone(),
            triangle_cdf: prepared.triangle_cdf.clone(),
            null_interfaces: (prepared.materials.iter())
                .any(|m| m.kind == MaterialKind::NullInterface),
            accel: (primitives.len() > LINEAR_PRIMITIVES).then(|| Accel::build(&primitives)),
            primitives,
        }
    }

    /// The least (t, shape, prim) with t < `ray.t_max`, `skip` passed over.
    pub fn nearest(&self, ray: Ray<F>, skip: Target) -> Hit<F> {
        let best = no_hit(ray.t_max);
        let best = match &self.accel {
            Some(accel) => accel.nearest(&self.primitives, ray, skip, best),
            None => self.primitives.nearest(ray, skip, best),
        };
        touching(&self.primitives, ray, best)
    }

    /// The obstacle of a shadow ray: the nearest hit if the scene has null interfaces, which let the ray pass; else any hit.
    pub fn obstacle(&self, ray: Ray<F>, skip: Target) -> Hit<F> {
        match &self.accel {
            Some(accel) if !self.null_interfaces => {
                let any = accel.any(&self.primitives, ray, skip, no_hit(ray.t_max));
                touching(&self.primitives, ray, any)
            }
            _ => self.nearest(ray, skip),
        }
    }

    /// Whether a face that comes first covers this one at the point `p`.
    pub fn is_covered_at(&self, shape: u32, prim: u32, p: Vec3<F>) -> bool {
        is_covered_at(&self.primitives, shape, prim, p)
    }

    /// The surface where `ray` has hit.
    pub fn hit_surface(&self, ray: Ray<F>, hit: Hit<F>) -> Surface<F> {
        let shape = &self.shapes[hit.shape as usize];
        self.primitives.surface(shape, ray, hit)
    }

    /// The light on a shape.
    pub fn light_of(&self, shape: u32) -> Option<usize> {
        let light = self.shapes[shape as usize].light;
        (light != NONE).then_some(light as usize)
    }

    /// The light chosen by `u24` < 2²⁴.
    pub fn light_choice(&self, u24: u32) -> usize {
        cdf_choice(&self.light_cdf, u24) as usize
    }

    /// Probability of choosing `light`.
    pub fn light_pmf(&self, light: usize) -> F {
        cdf_probability(&self.light_cdf, light as u32)
    }

    /// A direction from `p` to a point of `light`.
    pub fn light_sample(&self, light: usize, p: Vec3<F>, u24: u32, u: [F; 2]) -> LightSample<F> {
        let (light, cdf) = (&self.lights[light], &self.triangle_cdf);
        match (light.kind, &self.surroundings) {
            (LightKind::Background, _) => background_light_sample(u),
            (LightKind::Surroundings, Some(s)) => surroundings_light_sample(s, u),
            _ => self.primitives.light_sample(light, cdf, p, u24, u),
        }
    }

    /// Radiance of `light` at a point of primitive `prim`, or of the texel `prim` of surroundings.
    pub fn light_radiance(&self, light: usize, prim: u32) -> Vec3<F> {
        let Light { kind, radiance, .. } = self.lights[light];
        match (kind, &self.surroundings) {
            (LightKind::Surroundings, Some(s)) => radiance * surroundings_radiance(s, prim),
            _ => radiance,
        }
    }

    /// The light seen along `wi` from `light`, which is the background.
    pub fn outside_seen(&self, light: usize, wi: Vec3<F>) -> Outside<F> {
        let radiance = self.lights[light].radiance;
        match &self.surroundings {
            Some(s) => surroundings_outside(s, radiance, wi),
            None => background_outside(radiance),
        }
    }

    /// A point of `light`, uniform over its area.
    pub fn light_emission(&self, light: usize, u24: u32, u: [F; 2]) -> Emission<F> {
        let (light, cdf) = (&self.lights[light], &self.triangle_cdf);
        self.primitives.light_emission(light, cdf, u24, u)
    }

    /// Density per area with which [`Self::light_emission`] draws a point of primitive `prim` of `light` that `p` sees along
    /// `wi`; 0 on the inside of a light, which sends out no paths.
    pub fn emission_pdf(&self, light: usize, p: Vec3<F>, prim: u32, wi: Vec3<F>) -> F {
        let (light, cdf) = (&self.lights[light], &self.triangle_cdf);
        self.primitives.emission_pdf(light, cdf, p, prim, wi)
    }

    /// Density with which [`Self::light_sample`] from `p` would have drawn a point of primitive `prim` of `light`, at
    /// `distance` with the cosine |N_L·w|.
    pub fn light_pdf(&self, light: usize, p: Vec3<F>, prim: u32, cosine: F, distance: F) -> F {
        let (light, cdf) = (&self.lights[light], &self.triangle_cdf);
        self.primitives
            .light_pdf(light, cdf, p, prim, cosine, distance)
    }
}
