//! Triangles of meshes; twin of `shaders/shape/triangle.glsl` and `shaders/shape/triangle/`.

pub mod area;
pub mod hit;
pub mod nearer;
pub mod origin;

use super::normal::interpolated_normal;
use super::ray::{Hit, Surface};
use crate::prepared;
use crate::reference::math::{Real, Vec3};
use area::{triangle_area, triangle_point};
pub use hit::{RayShear, TriangleHit, ray_shear, triangle_hit};
pub use nearer::nearer_triangle;
pub use origin::triangle_self_distance;

/// Three corners, counter-clockwise as seen from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<F> {
    pub v: [Vec3<F>; 3],
    pub shape: u32,
}

impl<F: Real> Triangle<F> {
    /// Rounded to the scalar.
    pub fn new(t: &prepared::Triangle) -> Self {
        Self {
            v: t.v.map(Vec3::new),
            shape: t.shape,
        }
    }
}

/// The point that was hit, by its weights; the normal from the edges, the shading normal from `normals`,
/// those of the corners, where the mesh gives any.
pub fn triangle_surface<F: Real>(
    hit: Hit<F>,
    triangle: &Triangle<F>,
    normals: Option<&[Vec3<F>; 3]>,
) -> Surface<F> {
    let [v0, v1, v2] = triangle.v;
    let ng = triangle_area(v0, v1, v2).ng;
    Surface {
        p: triangle_point(v0, v1, v2, hit.uv),
        ng,
        ns: match normals {
            Some(n) => interpolated_normal(n[0], n[1], n[2], hit.uv, ng),
            None => ng,
        },
    }
}
