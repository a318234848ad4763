//! A prepared scene in the scalar of the reference: what the kernels read from buffers, and the dispatch that
//! they have generated.

use super::accel::{Accel, Primitives};
use super::bsdf::Material;
use super::camera::Camera;
use super::light::emission::{
    Emission, box_emission, cylinder_emission, mesh_emission, no_emission, sphere_emission,
};
use super::light::{
    LightSample, background_light_sample, box_light_pdf, box_light_sample, cdf_choice,
    cdf_probability, cylinder_light_pdf, cylinder_light_sample, mesh_light_pdf, mesh_light_sample,
    sphere_light_pdf, sphere_light_sample,
};
use super::math::{Real, Vec3};
use super::shape::{
    Cuboid, Cylinder, Hit, Ray, Sphere, Surface, Target, Triangle, box_surface, cylinder_surface,
    nearest_boxes, nearest_cylinders, nearest_spheres, nearest_triangles, no_hit, sphere_surface,
    triangle_surface,
};
pub use crate::prepared::record::light::scalar::Light;
use crate::prepared::{LightKind, NONE, Prepared, Shape, ShapeKind};

/// The scene that paths travel in.
pub struct World<F> {
    pub width: u32,
    pub camera: Camera<F>,
    pub eye_medium: u32,
    pub shapes: Vec<Shape>,
    pub spheres: Vec<Sphere<F>>,
    pub boxes: Vec<Cuboid<F>>,
    pub cylinders: Vec<Cylinder<F>>,
    pub triangles: Vec<Triangle<F>>,
    /// Of the corners of each triangle; empty where no mesh gives any.
    pub normals: Vec<[Vec3<F>; 3]>,
    pub materials: Vec<Material<F>>,
    pub lights: Vec<Light<F>>,
    /// Index of the background among the lights, where it shines.
    pub background_light: Option<usize>,
    /// Of each light, the material whose inside it stands in, or `NONE`.
    pub light_media: Vec<u32>,
    light_cdf: Vec<u32>,
    triangle_cdf: Vec<u32>,
    /// Over all primitives, where a loop over them would be slower.
    accel: Option<Accel<F>>,
}

/// Up to so many primitives are searched one by one; from there on the hierarchy is faster, whatever their kind
/// (`benches/2026-11-22-reference-search.md`).
const LINEAR_PRIMITIVES: usize = 16;

impl<F: Real> World<F> {
    /// Each number of `prepared` rounded to the scalar.
    pub fn new(prepared: &Prepared) -> Self {
        let mut world = Self {
            width: prepared.camera.width,
            camera: Camera::rounded(&prepared.camera, F::new),
            eye_medium: prepared.eye_medium,
            shapes: prepared.shapes.clone(),
            spheres: prepared
                .spheres
                .iter()
                .map(|r| Sphere::rounded(r, F::new))
                .collect(),
            boxes: prepared
                .boxes
                .iter()
                .map(|r| Cuboid::rounded(r, F::new))
                .collect(),
            cylinders: prepared
                .cylinders
                .iter()
                .map(|r| Cylinder::rounded(r, F::new))
                .collect(),
            triangles: prepared.triangles.iter().map(Triangle::new).collect(),
            normals: prepared.normals.iter().map(|n| n.map(Vec3::new)).collect(),
            materials: prepared
                .materials
                .iter()
                .map(|r| Material::rounded(r, F::new))
                .collect(),
            lights: prepared
                .lights
                .iter()
                .map(|r| Light::rounded(r, F::new))
                .collect(),
            background_light: prepared
                .lights
                .iter()
                .position(|l| l.kind == LightKind::Background),
            light_media: prepared.light_media.clone(),
            light_cdf: prepared.light_cdf.clone(),
            triangle_cdf: prepared.triangle_cdf.clone(),
            accel: None,
        };
        let primitives = world.primitives();
        if primitives.len() > LINEAR_PRIMITIVES {
            world.accel = Some(Accel::build(primitives));
        }
        world
    }

    fn primitives(&self) -> Primitives<'_, F> {
        Primitives {
            spheres: &self.spheres,
            boxes: &self.boxes,
            cylinders: &self.cylinders,
            triangles: &self.triangles,
        }
    }

    /// The least (t, shape, prim) with t < `ray.t_max`, `skip` passed over.
    pub fn nearest(&self, ray: Ray<F>, skip: Target) -> Hit<F> {
        let mut best = no_hit(ray.t_max);
        if let Some(accel) = &self.accel {
            return accel.nearest(self.primitives(), ray, skip, best);
        }
        best = nearest_spheres(&self.spheres, ray, skip, best);
        best = nearest_boxes(&self.boxes, ray, skip, best);
        best = nearest_cylinders(&self.cylinders, ray, skip, best);
        nearest_triangles(&self.triangles, ray, skip, best)
    }

    /// The surface where `ray` has hit.
    pub fn hit_surface(&self, ray: Ray<F>, hit: Hit<F>) -> Surface<F> {
        let shape = &self.shapes[hit.shape as usize];
        let first = shape.first as usize;
        match shape.kind {
            ShapeKind::Sphere => sphere_surface(ray, hit, &self.spheres[first]),
            ShapeKind::Box => box_surface(ray, hit, &self.boxes[first]),
            ShapeKind::Cylinder => cylinder_surface(ray, hit, &self.cylinders[first]),
            ShapeKind::Mesh => {
                let prim = hit.prim as usize;
                triangle_surface(hit, &self.triangles[prim], self.normals.get(prim))
            }
        }
    }

    /// The light that a shape is.
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

    /// The n + 1 entries of a mesh of n triangles in the table that chooses one.
    fn triangles_of(&self, light: &Light<F>) -> &[u32] {
        let first = light.cdf as usize;
        &self.triangle_cdf[first..=first + light.count as usize]
    }

    /// A direction from `p` to a point of `light`.
    pub fn light_sample(&self, light: usize, p: Vec3<F>, u24: u32, u: [F; 2]) -> LightSample<F> {
        let l = &self.lights[light];
        let first = l.first as usize;
        match l.kind {
            LightKind::Sphere => {
                let s = &self.spheres[first];
                sphere_light_sample(p, s.centre, s.radius, u)
            }
            LightKind::Box => {
                let b = &self.boxes[first];
                box_light_sample(p, b.lo, b.hi, u24, u)
            }
            LightKind::Cylinder => cylinder_light_sample(p, &self.cylinders[first], u24, u),
            LightKind::Mesh => {
                let cdf = self.triangles_of(l);
                mesh_light_sample(p, &self.triangles, l.first, cdf, u24, u)
            }
            LightKind::Background => background_light_sample(u),
        }
    }

    /// A point of `light`, uniform over its area.
    pub fn light_emission(&self, light: usize, u24: u32, u: [F; 2]) -> Emission<F> {
        let l = &self.lights[light];
        let first = l.first as usize;
        match l.kind {
            LightKind::Sphere => {
                let s = &self.spheres[first];
                sphere_emission(s.centre, s.radius, u)
            }
            LightKind::Box => {
                let b = &self.boxes[first];
                box_emission(b.lo, b.hi, u24, u)
            }
            LightKind::Cylinder => cylinder_emission(&self.cylinders[first], u24, u),
            LightKind::Mesh => {
                let cdf = self.triangles_of(l);
                mesh_emission(&self.triangles, l.first, cdf, u24, u)
            }
            LightKind::Background => no_emission(),
        }
    }

    /// Density with which [`Self::light_sample`] from `p` would have drawn a point of primitive `prim` of `light`,
    /// `distance` away under the cosine |N_L·w|.
    pub fn light_pdf(&self, light: usize, p: Vec3<F>, prim: u32, cosine: F, distance: F) -> F {
        let l = &self.lights[light];
        let first = l.first as usize;
        match l.kind {
            LightKind::Sphere => {
                let s = &self.spheres[first];
                sphere_light_pdf(p, s.centre, s.radius, distance, cosine)
            }
            LightKind::Box => {
                let b = &self.boxes[first];
                box_light_pdf(p, b.lo, b.hi, distance, cosine)
            }
            LightKind::Cylinder => cylinder_light_pdf(p, &self.cylinders[first], distance, cosine),
            LightKind::Mesh => {
                let cdf = self.triangles_of(l);
                mesh_light_pdf(&self.triangles, l.first, cdf, prim, distance, cosine)
            }
            LightKind::Background => super::light::background_light_pdf(),
        }
    }
}
