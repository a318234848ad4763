//! The primitives of a scene in the scalar, and the dispatch among their kinds that the kernels have generated.

use super::light::emission::{
    Emission, box_emission, box_emission_pdf, cylinder_emission, cylinder_emission_pdf,
    mesh_emission, mesh_emission_pdf, no_emission, sphere_emission, sphere_emission_pdf,
};
use super::light::{
    LightSample, box_light_pdf, box_light_sample, cylinder_light_pdf, cylinder_light_sample,
    mesh_light_pdf, mesh_light_sample, sphere_light_pdf, sphere_light_sample,
};
use super::math::{Real, Vec3};
use super::shape::cover::Cover;
use super::shape::face::{
    FacePoint, box_face_point, cylinder_face_point, sphere_face_point, triangle_face_point,
};
use super::shape::linear::{nearer_box, nearer_cylinder, nearer_sphere};
use super::shape::{
    Cuboid, Cylinder, Hit, Ray, RayShear, Sphere, Surface, Target, Triangle, box_surface,
    cylinder_surface, nearer_triangle, nearest_boxes, nearest_cylinders, nearest_spheres,
    nearest_triangles, ray_shear, sphere_surface, triangle_surface,
};
pub use crate::prepared::record::light::scalar::Light;
use crate::prepared::{LightKind, Shape};
use crate::shape::{self, Bounds, Coincidence, Coincidences, Primitive, ShapeKind};

/// Each kind in its own array; numbered consecutively in this order.
#[derive(Clone, Debug)]
pub struct Primitives<F> {
    pub spheres: Vec<Sphere<F>>,
    pub boxes: Vec<Cuboid<F>>,
    pub cylinders: Vec<Cylinder<F>>,
    pub triangles: Vec<Triangle<F>>,
    /// The corners' normals of each triangle; empty if no mesh gives any.
    pub normals: Vec<[Vec3<F>; 3]>,
    pub coincident: Coincidences,
}

impl<F: Real> Primitives<F> {
    /// Each number rounded to the scalar.
    pub fn new(p: &shape::Primitives) -> Self {
        let (spheres, boxes) = (p.spheres.iter(), p.boxes.iter());
        let (cylinders, triangles) = (p.cylinders.iter(), p.triangles.iter());
        Self {
            spheres: spheres.map(|s| Sphere::rounded(s, F::new)).collect(),
            boxes: boxes.map(|b| Cuboid::rounded(b, F::new)).collect(),
            cylinders: cylinders.map(|c| Cylinder::rounded(c, F::new)).collect(),
            triangles: triangles.map(|t| t.map(Vec3::new)).collect(),
            normals: p.normals.iter().map(|n| n.map(Vec3::new)).collect(),
            coincident: p.coincident.clone(),
        }
    }

    /// The box around each, taken exactly from its numbers.
    pub fn extents(&self) -> impl Iterator<Item = Bounds> {
        let spheres = self.spheres.iter().map(|s| s.widened(F::f64).extent());
        let boxes = self.boxes.iter().map(|b| b.widened(F::f64).extent());
        let cylinders = self.cylinders.iter().map(|c| c.widened(F::f64).extent());
        let triangles = self.triangles.iter().map(|t| t.map(Vec3::f64).extent());
        let solids = spheres.chain(boxes).chain(cylinders);
        solids.chain(triangles)
    }

    /// Primitive `number`, if it is a triangle.
    pub fn triangle(&self, number: usize) -> Option<&Triangle<F>> {
        let solids = self.len() - self.triangles.len();
        self.triangles.get(number.checked_sub(solids)?)
    }

    /// The number of primitives.
    pub fn len(&self) -> usize {
        self.spheres.len() + self.boxes.len() + self.cylinders.len() + self.triangles.len()
    }

    /// Whether there are no primitives.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The nearer of `best` and the hit with primitive `number`.
    #[inline]
    pub fn nearer(
        &self,
        number: usize,
        ray: Ray<F>,
        shear: RayShear<F>,
        skip: Target,
        best: Hit<F>,
        cover: &impl Cover<F>,
    ) -> Hit<F> {
        let boxes = self.spheres.len();
        let cylinders = boxes + self.boxes.len();
        let triangles = cylinders + self.cylinders.len();
        if number >= triangles {
            let prim = number - triangles;
            nearer_triangle(
                ray,
                shear,
                skip,
                best,
                &self.triangles[prim],
                prim as u32,
                cover,
            )
        } else if number >= cylinders {
            nearer_cylinder(ray, skip, best, &self.cylinders[number - cylinders], cover)
        } else if number >= boxes {
            nearer_box(ray, skip, best, &self.boxes[number - boxes], cover)
        } else {
            nearer_sphere(ray, skip, best, &self.spheres[number], cover)
        }
    }

    /// The least of `best` and the hits with all primitives, each of which is tried.
    pub fn nearest(&self, ray: Ray<F>, skip: Target, mut best: Hit<F>) -> Hit<F> {
        if !self.coincident.is_empty() {
            let shear = ray_shear(ray.d);
            let nearer = |best, number| self.nearer(number, ray, shear, skip, best, self);
            return (0..self.len()).fold(best, nearer);
        }
        best = nearest_spheres(&self.spheres, ray, skip, best);
        best = nearest_boxes(&self.boxes, ray, skip, best);
        best = nearest_cylinders(&self.cylinders, ray, skip, best);
        nearest_triangles(&self.triangles, ray, skip, best)
    }

    /// Whether `p`, in the plane of a face, lies on it.
    pub fn face_point(&self, face: &Coincidence, p: Vec3<F>) -> FacePoint<F> {
        let index = face.index as usize;
        match face.kind {
            ShapeKind::Sphere => sphere_face_point(),
            ShapeKind::Box => box_face_point(&self.boxes[index], face.prim, p),
            ShapeKind::Cylinder => cylinder_face_point(&self.cylinders[index], face.prim, p),
            ShapeKind::Mesh => {
                let [v0, v1, v2] = self.triangles[index].v;
                triangle_face_point(v0, v1, v2, p)
            }
        }
    }

    /// The surface of `shape` where `ray` has hit it.
    pub fn surface(&self, shape: &Shape, ray: Ray<F>, hit: Hit<F>) -> Surface<F> {
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

    /// A direction from `p` to a point of `light`, which is a shape; `cdf` has the choice among the triangles of every mesh.
    pub fn light_sample(
        &self,
        light: &Light<F>,
        cdf: &[u32],
        p: Vec3<F>,
        u24: u32,
        u: [F; 2],
    ) -> LightSample<F> {
        let first = light.first as usize;
        match light.kind {
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
                let cdf = Self::part(cdf, light);
                mesh_light_sample(p, &self.triangles, light.first, cdf, u24, u)
            }
            LightKind::Background | LightKind::Surroundings => LightSample::none(),
        }
    }

    /// A point of `light`, uniform over its area.
    pub fn light_emission(
        &self,
        light: &Light<F>,
        cdf: &[u32],
        u24: u32,
        u: [F; 2],
    ) -> Emission<F> {
        let first = light.first as usize;
        match light.kind {
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
                let cdf = Self::part(cdf, light);
                mesh_emission(&self.triangles, light.first, cdf, u24, u)
            }
            LightKind::Background | LightKind::Surroundings => no_emission(),
        }
    }

    /// Density per area with which [`Self::light_emission`] draws a point of primitive `prim` of `light` that `p` sees along
    /// `wi`; 0 on the inside of a light, which sends out no paths.
    pub fn emission_pdf(
        &self,
        light: &Light<F>,
        cdf: &[u32],
        p: Vec3<F>,
        prim: u32,
        wi: Vec3<F>,
    ) -> F {
        let first = light.first as usize;
        match light.kind {
            LightKind::Sphere => {
                let s = &self.spheres[first];
                sphere_emission_pdf(p, s.centre, s.radius)
            }
            LightKind::Box => {
                let b = &self.boxes[first];
                box_emission_pdf(p, b.lo, b.hi)
            }
            LightKind::Cylinder => cylinder_emission_pdf(p, &self.cylinders[first]),
            LightKind::Mesh => {
                let cdf = Self::part(cdf, light);
                mesh_emission_pdf(&self.triangles, light.first, cdf, prim, wi)
            }
            LightKind::Background | LightKind::Surroundings => F::zero(),
        }
    }

    /// Density with which [`Self::light_sample`] from `p` would have drawn a point of primitive `prim` of `light`, at
    /// `distance` with the cosine |N_L·w|.
    pub fn light_pdf(
        &self,
        light: &Light<F>,
        cdf: &[u32],
        p: Vec3<F>,
        prim: u32,
        cosine: F,
        distance: F,
    ) -> F {
        let first = light.first as usize;
        match light.kind {
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
                let cdf = Self::part(cdf, light);
                mesh_light_pdf(&self.triangles, light.first, cdf, prim, distance, cosine)
            }
            LightKind::Background | LightKind::Surroundings => F::zero(),
        }
    }

    /// The n + 1 entries of a mesh of n triangles in the table of all.
    fn part<'a>(cdf: &'a [u32], light: &Light<F>) -> &'a [u32] {
        let first = light.cdf as usize;
        &cdf[first..=first + light.count as usize]
    }
}
