//! Meshes of triangles.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Body, Bounds, Description, Primitive, Space};

/// Three corners, counter-clockwise as seen from outside. The kernels store nine floats and the shape's index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<V = DVec3> {
    pub v: [V; 3],
    /// Index of its shape.
    pub shape: u32,
}

pub const DESCRIPTION: Description = Description {
    name: "mesh",
    primitives: ["triangle", "triangles"],
    array: "triangle_shapes",
    ty: "Triangle",
    declaration: None,
    element: "triangle_at({i})",
    once: Some(["RayShear", "ray_shear(ray.d)"]),
    nearer_file: "shape/triangle/nearer",
    nearer: "nearer_triangle(ray, {once}, skip, {best}, {x}, {i})",
    surface_file: "shape/triangle",
    surface: "triangle_surface(hit)",
    face_file: "shape/face/triangle",
    face_point: "triangle_face_point({x}.v0, {x}.v1, {x}.v2, p)",
    light_file: "light/mesh",
    light_sample: "mesh_light_sample(p, {light}.first, {light}.count, {light}.cdf, u24, u)",
    light_pdf: "mesh_light_pdf({light}.first, {light}.cdf, prim, distance, cosine)",
    emission_file: "light/emission/mesh",
    emission: "mesh_emission({light}.first, {light}.count, {light}.cdf, u24, u)",
    emission_pdf: "mesh_emission_pdf({light}.first, {light}.cdf, prim, wi)",
};

impl<V> Triangle<V> {
    /// The same triangle with each vector mapped by `f`.
    pub fn map<W>(self, f: impl Fn(V) -> W) -> Triangle<W> {
        Triangle {
            v: self.v.map(f),
            shape: self.shape,
        }
    }
}

/// The triangles of one mesh.
pub struct Mesh<'a>(pub &'a [Triangle]);

impl Body for Mesh<'_> {
    fn bounds(&self) -> Bounds {
        Bounds::around(self.0.iter().flat_map(|t| t.v))
    }

    /// Whether the mesh, which is closed, encloses `p`.
    fn contains(&self, p: DVec3) -> bool {
        let angle = |t: &Triangle| solid_angle(t.v.map(|v| v - p));
        let sum: f64 = self.0.iter().map(angle).sum();
        sum.abs() > 2.0 * PI
    }

    fn areas(&self) -> Vec<f64> {
        let area = |[a, b, c]: [DVec3; 3]| 0.5 * (b - a).cross(c - a).length();
        self.0.iter().map(|t| area(t.v)).collect()
    }

    fn thickness(&self) -> f64 {
        let bounds = self.bounds();
        (bounds.hi - bounds.lo).max_element()
    }

    fn distance(&self, _: DVec3) -> Option<f64> {
        None
    }
}

impl Primitive for Triangle {
    fn extent(&self) -> Bounds {
        Bounds::around(self.v)
    }

    fn extent_in_f32(&self) -> Bounds {
        self.map(|v| v.as_vec3().as_dvec3()).extent()
    }

    fn move_to(&mut self, space: &Space) {
        self.v = self.v.map(|v| space.point(v));
    }
}

/// Signed solid angle of a triangle seen from the origin; over a closed mesh the sum is 4π inside, 0 outside.
///
/// tan(Ω/2) = a·(b×c) / (abc + (a·b)c + (a·c)b + (b·c)a): Van Oosterom & Strackee, The Solid Angle of a Plane Triangle,
/// 1983, eq. 8.
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let denominator = la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la;
    2.0 * a.dot(b.cross(c)).atan2(denominator)
}
