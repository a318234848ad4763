//! The reference's own acceleration structure: the nearest hit without trying every primitive, the same hit
//! to the last bit.

mod bounds;
mod slabs;
mod split;
mod tree;

use super::math::Real;
use super::shape::linear::{nearer_box, nearer_cylinder, nearer_sphere};
use super::shape::{
    Cuboid, Cylinder, Hit, Ray, Sphere, Target, Triangle, nearer_triangle, ray_shear,
};
use crate::prepared::Bounds;
use bounds::{of_box, of_cylinder, of_sphere, of_triangle};
use tree::Tree;

/// All primitives of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Primitives<'a, F> {
    pub spheres: &'a [Sphere<F>],
    pub boxes: &'a [Cuboid<F>],
    pub cylinders: &'a [Cylinder<F>],
    pub triangles: &'a [Triangle<F>],
}

/// A hierarchy over the primitives of a scene, numbered through: spheres, boxes, cylinders, triangles.
pub struct Accel<F> {
    tree: Tree<F>,
}

impl<F: Real> Accel<F> {
    /// The hierarchy over all primitives; the same for the same primitives.
    pub fn build(primitives: Primitives<F>) -> Self {
        let p = primitives;
        let bounds: Vec<Bounds> = (p.spheres.iter().map(of_sphere))
            .chain(p.boxes.iter().map(of_box))
            .chain(p.cylinders.iter().map(of_cylinder))
            .chain(p.triangles.iter().map(of_triangle))
            .collect();
        Self {
            tree: Tree::new(&bounds),
        }
    }

    /// The least of `best` and all hits with the primitives that the hierarchy was built over, by
    /// (t, shape, prim); `skip` is passed over. A search for hits before `t_max` begins with
    /// [`no_hit`](super::shape::no_hit).
    pub fn nearest(
        &self,
        primitives: Primitives<F>,
        ray: Ray<F>,
        skip: Target,
        mut best: Hit<F>,
    ) -> Hit<F> {
        let shear = ray_shear(ray.d);
        let t_max = best.t;
        self.tree.traverse(ray.o, ray.d, t_max, |number| {
            best = match primitives.find(number as usize) {
                Primitive::Sphere(s) => nearer_sphere(ray, skip, best, s),
                Primitive::Box(b) => nearer_box(ray, skip, best, b),
                Primitive::Cylinder(c) => nearer_cylinder(ray, skip, best, c),
                Primitive::Triangle(t, prim) => nearer_triangle(ray, shear, skip, best, t, prim),
            };
            best.t
        });
        best
    }
}

/// A primitive; a triangle with its index among all.
enum Primitive<'a, F> {
    Sphere(&'a Sphere<F>),
    Box(&'a Cuboid<F>),
    Cylinder(&'a Cylinder<F>),
    Triangle(&'a Triangle<F>, u32),
}

impl<'a, F> Primitives<'a, F> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.spheres.len() + self.boxes.len() + self.cylinders.len() + self.triangles.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The primitive with the number that [`Accel::build`] gave it.
    fn find(&self, number: usize) -> Primitive<'a, F> {
        let boxes = self.spheres.len();
        let cylinders = boxes + self.boxes.len();
        let triangles = cylinders + self.cylinders.len();
        if number >= triangles {
            let prim = number - triangles;
            Primitive::Triangle(&self.triangles[prim], prim as u32)
        } else if number >= cylinders {
            Primitive::Cylinder(&self.cylinders[number - cylinders])
        } else if number >= boxes {
            Primitive::Box(&self.boxes[number - boxes])
        } else {
            Primitive::Sphere(&self.spheres[number])
        }
    }
}
