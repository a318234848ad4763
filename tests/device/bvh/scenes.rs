//! Scenes that are hard for a hierarchy, each small enough for brute force.

use glam::{DVec2, DVec3};
use vkpt::prepared::{
    Camera, Cuboid, Cylinder, NONE, Prepared, Primitives, Shape, ShapeKind, Space, Sphere, Triangle,
};

use super::random::Random;
use crate::common::icosphere::icosphere;

/// A scene without materials and lights, filled shape by shape.
pub struct Builder(Prepared);

impl Builder {
    pub fn new() -> Self {
        Self(Prepared {
            space: Space {
                origin: DVec3::ZERO,
                unit: 1.0,
            },
            camera: Camera {
                eye: DVec3::ZERO,
                width: 1,
                height: 1,
                right: DVec3::X,
                up: DVec3::Y,
                forward: DVec3::Z,
            },
            shapes: Vec::new(),
            primitives: Primitives::default(),
            materials: Vec::new(),
            lights: Vec::new(),
            aims: Vec::new(),
            light_share: None,
            light_media: Vec::new(),
            light_cdf: Vec::new(),
            light_tree: Default::default(),
            triangle_cdf: Vec::new(),
            background: DVec3::ZERO,
            surroundings: None,
            background_line: 0,
            lens: None,
            eye_medium: NONE,
            warnings: Vec::new(),
        })
    }

    /// Announces a shape and returns its index.
    fn shape(&mut self, kind: ShapeKind, first: usize, count: usize) -> u32 {
        self.0.shapes.push(Shape {
            kind,
            first: first as u32,
            count: count as u32,
            material: 0,
            light: NONE,
            line: 0,
        });
        self.0.shapes.len() as u32 - 1
    }

    pub fn sphere(mut self, centre: DVec3, radius: f64) -> Self {
        let shape = self.shape(ShapeKind::Sphere, self.0.primitives.spheres.len(), 1);
        self.0.primitives.spheres.push(Sphere {
            centre,
            radius,
            shape,
        });
        self
    }

    pub fn cuboid(mut self, lo: DVec3, hi: DVec3) -> Self {
        let shape = self.shape(ShapeKind::Box, self.0.primitives.boxes.len(), 1);
        self.0.primitives.boxes.push(Cuboid { lo, hi, shape });
        self
    }

    pub fn cylinder(mut self, base: DVec3, axis: DVec3, radius: f64) -> Self {
        let shape = self.shape(ShapeKind::Cylinder, self.0.primitives.cylinders.len(), 1);
        let w = axis.normalize();
        let (u, v) = w.any_orthonormal_pair();
        let height = axis.length();
        self.0.primitives.cylinders.push(Cylinder {
            base,
            u,
            v,
            w,
            height,
            radius,
            shape,
        });
        self
    }

    pub fn mesh(mut self, triangles: impl IntoIterator<Item = [DVec3; 3]>) -> Self {
        let triangles: Vec<_> = triangles.into_iter().collect();
        let shape = self.shape(
            ShapeKind::Mesh,
            self.0.primitives.triangles.len(),
            triangles.len(),
        );
        self.0
            .primitives
            .triangles
            .extend(triangles.into_iter().map(|v| Triangle { v, shape }));
        self
    }

    pub fn build(self) -> Prepared {
        self.0
    }
}

/// One triangle.
pub fn one_triangle() -> Prepared {
    Builder::new()
        .mesh([[DVec3::ZERO, DVec3::X, DVec3::new(0.3, 1.0, 0.2)]])
        .build()
}

/// The cube [−1, 1]³ of twelve triangles.
pub fn cube() -> Prepared {
    Builder::new().mesh(cube_faces(DVec3::ZERO, 1.0)).build()
}

/// 20·12² triangles in bumps.
pub fn blob() -> Prepared {
    Builder::new().mesh(icosphere(12, 7)).build()
}

/// Every triangle of a subdivided square three times: twice in one mesh, once in another. All hits are ties.
pub fn coplanar_duplicates() -> Prepared {
    let once = grid(8);
    let twice: Vec<_> = once.iter().chain(&once).copied().collect();
    Builder::new().mesh(twice).mesh(once).build()
}

/// Triangles 1 long and 1e-6 wide in all directions.
pub fn needles() -> Prepared {
    let mut random = Random::new(11);
    let needle = |_| {
        let (p, d) = (random.in_cube(), random.direction());
        let side = d.any_orthonormal_vector() * 1e-6;
        [p - d * 0.5, p + d * 0.5 + side, p + d * 0.5 - side]
    };
    Builder::new()
        .mesh((0..500).map(needle).collect::<Vec<_>>())
        .build()
}

/// Triangles without area, points among them, between others that have some.
pub fn zero_area() -> Prepared {
    let mut random = Random::new(12);
    let triangle = |k: u32| {
        let [a, b, c] = [random.in_cube(), random.in_cube(), random.in_cube()];
        match k % 4 {
            0 => [a, a, a],
            1 => [a, b, (a + b) * 0.5],
            2 => [a, b, a],
            _ => [a, b, c],
        }
    };
    Builder::new()
        .mesh((0..400).map(triangle).collect::<Vec<_>>())
        .build()
}

/// Spheres, boxes, cylinders and small cubes, some overlapping, some touching.
pub fn mixed() -> Prepared {
    let mut random = Random::new(13);
    let mut builder = Builder::new();
    for k in 0..200 {
        let p = random.in_cube() * 4.0;
        let size = 0.05 + 0.4 * random.unit();
        builder = match k % 5 {
            0 => builder.sphere(p, size),
            1 => builder.cuboid(p, p + DVec3::new(size, 0.5 * size, 2.0 * size)),
            2 => builder.cylinder(p, random.direction() * size * 2.0, 0.3 * size),
            3 => builder.cylinder(p, [DVec3::X, DVec3::Y, DVec3::Z][k % 3] * size, size),
            _ => builder.mesh(cube_faces(p, size)),
        };
    }
    // A ball, a box and a cylinder that stand on the top face of the same box, exactly.
    builder
        .cuboid(DVec3::new(-5.0, -5.0, -6.0), DVec3::new(5.0, 5.0, -5.0))
        .sphere(DVec3::new(0.0, 0.0, -4.0), 1.0)
        .cuboid(DVec3::new(2.0, 2.0, -5.0), DVec3::new(3.0, 3.0, -4.0))
        .cylinder(DVec3::new(-2.0, 2.0, -5.0), DVec3::Z, 0.5)
        .build()
}

/// The scene in another unit of length.
pub fn scaled(mut scene: Prepared, k: f64) -> Prepared {
    for s in &mut scene.primitives.spheres {
        (s.centre, s.radius) = (s.centre * k, s.radius * k);
    }
    for b in &mut scene.primitives.boxes {
        (b.lo, b.hi) = (b.lo * k, b.hi * k);
    }
    for c in &mut scene.primitives.cylinders {
        (c.base, c.height, c.radius) = (c.base * k, c.height * k, c.radius * k);
    }
    for t in &mut scene.primitives.triangles {
        t.v = t.v.map(|v| v * k);
    }
    scene
}

/// n spheres of many sizes.
pub fn spheres(n: u32) -> Prepared {
    let mut random = Random::new(14);
    (0..n)
        .fold(Builder::new(), |builder, _| {
            let radius = 0.1 * random.unit().powi(3) + 1e-4;
            builder.sphere(random.in_cube() * 5.0, radius)
        })
        .build()
}

/// A square in z = 0, [0, 1]², cut into 2·n² triangles at planes that are exact in `f32`.
pub fn grid(n: u32) -> Vec<[DVec3; 3]> {
    let at = |i: u32, j: u32| (DVec2::new(f64::from(i), f64::from(j)) / f64::from(n)).extend(0.0);
    let cell = |i, j| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    (0..n)
        .flat_map(|i| (0..n).flat_map(move |j| cell(i, j)))
        .collect()
}

/// The faces of the cube of half side `r` about `p`, two triangles each.
fn cube_faces(p: DVec3, r: f64) -> Vec<[DVec3; 3]> {
    let mut faces = Vec::new();
    for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        for side in [-r, r] {
            let corner = |s: f64, t: f64| {
                let mut v = p;
                v[axes[0]] += side;
                v[axes[1]] += s * side;
                v[axes[2]] += t * r;
                v
            };
            let [a, b, c, d] = [
                corner(-1.0, -1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
            ];
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    faces
}

/// All of them, by name.
pub fn all() -> Vec<(&'static str, Prepared)> {
    vec![
        ("one triangle", one_triangle()),
        ("cube", cube()),
        ("blob", blob()),
        ("coplanar duplicates", coplanar_duplicates()),
        ("needles", needles()),
        ("zero area", zero_area()),
        ("mixed", mixed()),
        ("spheres", spheres(10_000)),
        ("tiny", scaled(mixed(), 1e-5)),
        ("large", scaled(mixed(), 1e5)),
    ]
}
