//! Rays that a hierarchy could get wrong: through corners and edges, along faces, along axes, from afar, from within.

use glam::DVec3;
use vkpt::prepared::{Cuboid, Cylinder, NONE, Prepared, ShapeKind, Sphere, Triangle};
use vkpt::reference::math::{Real, Vec3, vec3};
use vkpt::reference::shape::{
    FAR, Ray, START_ELSEWHERE, START_INSIDE, START_OUTSIDE, Target, triangle_self_distance,
};

use super::random::Random;

/// A search for the nearest hit.
#[derive(Clone, Copy, Debug)]
pub struct Query<F> {
    pub ray: Ray<F>,
    pub t_max: F,
    pub skip: Target,
}

/// A place on a primitive that is worth aiming at.
struct Anchor {
    p: DVec3,
    /// A normal there.
    n: DVec3,
    /// A direction along the surface there.
    tangent: DVec3,
    shape: u32,
    prim: u32,
}

/// An endless supply of queries about a scene.
pub struct Rays<'a> {
    prepared: &'a Prepared,
    random: Random,
    extent: f64,
}

impl<'a> Rays<'a> {
    pub fn new(prepared: &'a Prepared, seed: u64) -> Self {
        let p = &prepared.primitives;
        let corners = p.triangles.iter().flat_map(|t| t.v);
        let spheres = p.spheres.iter().map(|s| s.centre.abs() + s.radius);
        let boxes = p.boxes.iter().map(|b| b.lo.abs().max(b.hi.abs()));
        let cylinders = (p.cylinders.iter()).map(|c| c.base.abs() + c.height + c.radius);
        let all = corners.chain(spheres).chain(boxes).chain(cylinders);
        Self {
            prepared,
            random: Random::new(seed),
            extent: all
                .fold(DVec3::ZERO, |most, p| most.max(p.abs()))
                .max_element(),
        }
    }

    pub fn next<F: Real>(&mut self) -> Query<F> {
        let a = self.anchor();
        let distance = self.extent * (0.1 + 3.0 * self.random.unit());
        let toward = |d: DVec3, distance: f64| (a.p - d * distance, d);
        let (o, d) = match self.random.below(8) {
            0 => (
                self.random.in_cube() * self.extent * 1.5,
                self.random.direction(),
            ),
            1 | 2 => toward(self.random.direction(), distance),
            3 => toward(self.random.direction(), 1e4 * distance),
            4 => toward((a.tangent + a.n * self.tilt()).normalize(), distance),
            5 => toward(self.axis(), distance),
            6 => (
                a.p,
                if self.random.below(4) == 0 {
                    a.tangent
                } else {
                    self.random.direction()
                },
            ),
            _ => (
                a.p - a.n * self.extent * 0.1 * self.random.unit(),
                self.random.direction(),
            ),
        };
        let mut ray = Ray::new(Vec3::new(o), self.signed_zeros(Vec3::new(d)));
        if o == a.p && self.random.below(4) != 0 {
            self.start_on(&mut ray, &a, d);
        }
        let skip = match self.random.below(4) {
            0 => self.target(&a),
            _ => Target::none(),
        };
        let t_max = match self.random.below(4) {
            0 => F::new(distance),
            _ => F::new(FAR),
        };
        Query { ray, t_max, skip }
    }

    /// None, or next to none on either side.
    fn tilt(&mut self) -> f64 {
        [0.0, 1e-7, -1e-7, 1e-6, -1e-4][self.random.below(5)]
    }

    /// Along one axis.
    fn axis(&mut self) -> DVec3 {
        let axis = [DVec3::X, DVec3::Y, DVec3::Z][self.random.below(3)];
        if self.random.below(2) == 0 {
            axis
        } else {
            -axis
        }
    }

    /// Zeros of a random sign.
    fn signed_zeros<F: Real>(&mut self, d: Vec3<F>) -> Vec3<F> {
        let mut signed = |x: F| {
            let negative = self.random.below(2) == 0;
            if x == F::zero() {
                F::new(if negative { -0.0 } else { 0.0 })
            } else {
                x
            }
        };
        vec3(signed(d.x), signed(d.y), signed(d.z))
    }

    /// The anchor's own shape; of a mesh the triangle.
    fn target(&self, a: &Anchor) -> Target {
        match self.prepared.shapes[a.shape as usize].kind {
            ShapeKind::Mesh => Target {
                shape: a.shape,
                prim: a.prim,
            },
            _ => Target {
                shape: a.shape,
                prim: NONE,
            },
        }
    }

    fn start_on<F: Real>(&self, ray: &mut Ray<F>, a: &Anchor, d: DVec3) {
        ray.shape = a.shape;
        ray.prim = a.prim;
        ray.start = if d.dot(a.n) > 0.0 {
            START_OUTSIDE
        } else {
            START_INSIDE
        };
        if self.prepared.shapes[a.shape as usize].kind == ShapeKind::Mesh {
            ray.t_self = triangle_self_distance(ray.o, Vec3::new(a.n), ray.d);
        }
        assert_ne!(ray.start, START_ELSEWHERE);
    }

    fn anchor(&mut self) -> Anchor {
        let p = &self.prepared.primitives;
        let solids = p.spheres.len() + p.boxes.len() + p.cylinders.len();
        let i = self.random.below(solids + p.triangles.len());
        if i >= solids {
            return self.on_triangle(&p.triangles[i - solids], (i - solids) as u32);
        }
        if i < p.spheres.len() {
            return self.on_sphere(&p.spheres[i]);
        }
        match p.boxes.get(i - p.spheres.len()) {
            Some(b) => self.on_box(b),
            None => self.on_cylinder(&p.cylinders[i - p.spheres.len() - p.boxes.len()]),
        }
    }

    /// A corner, a point of an edge, or one within.
    fn on_triangle(&mut self, t: &Triangle, prim: u32) -> Anchor {
        let k = self.random.below(3);
        let [a, b, c] = [t.v[k], t.v[(k + 1) % 3], t.v[(k + 2) % 3]];
        let u = self.random.unit();
        let p = match self.random.below(4) {
            0 => a,
            1 | 2 => a + (b - a) * u,
            _ => a + (b - a) * u + (c - a) * (1.0 - u) * self.random.unit(),
        };
        Anchor {
            p,
            n: (b - a).cross(c - a).normalize_or(DVec3::Z),
            tangent: (b - a).normalize_or(DVec3::X),
            shape: t.shape,
            prim,
        }
    }

    fn on_sphere(&mut self, s: &Sphere) -> Anchor {
        let n = match self.random.below(4) {
            0 => self.axis(),
            _ => self.random.direction(),
        };
        Anchor {
            p: s.centre + n * s.radius,
            n,
            tangent: n.cross(self.random.direction()).normalize_or(DVec3::X),
            shape: s.shape,
            prim: 0,
        }
    }

    /// A corner, a point of an edge, or one of a face.
    fn on_box(&mut self, b: &Cuboid) -> Anchor {
        let axis = self.random.below(3);
        let upper = self.random.below(2);
        let mut p = DVec3::ZERO;
        for k in 0..3 {
            let inner = if self.random.below(2) == 0 {
                self.random.unit()
            } else {
                self.random.below(2) as f64
            };
            let share = if k == axis { upper as f64 } else { inner };
            p[k] = if share == 1.0 {
                b.hi[k]
            } else {
                b.lo[k] + (b.hi[k] - b.lo[k]) * share
            };
        }
        let n = DVec3::AXES[axis] * (2.0 * upper as f64 - 1.0);
        Anchor {
            p,
            n,
            tangent: DVec3::AXES[(axis + 1) % 3],
            shape: b.shape,
            prim: 2 * axis as u32 + upper as u32,
        }
    }

    /// On the side, on a rim or on a cap.
    fn on_cylinder(&mut self, c: &Cylinder) -> Anchor {
        let (sin, cos) = (self.random.unit() * std::f64::consts::TAU).sin_cos();
        let out = c.u * cos + c.v * sin;
        let part = self.random.below(3);
        let (rho, z) = match (part, self.random.below(3)) {
            (0, 0) => (1.0, 1.0),
            (0, _) => (1.0, self.random.unit()),
            (part, 0) => (1.0, part as f64 - 1.0),
            (part, _) => (self.random.unit(), part as f64 - 1.0),
        };
        Anchor {
            p: c.base + c.w * c.height * z + out * c.radius * rho,
            n: [out, -c.w, c.w][part],
            tangent: if self.random.below(2) == 0 {
                out.cross(c.w)
            } else {
                [c.w, out, out][part]
            },
            shape: c.shape,
            prim: part as u32,
        }
    }
}
