//! Triangles of meshes; twin of `shaders/shape/triangle.glsl` and `shaders/shape/triangle/`.

pub mod area;
pub mod hit;
pub mod nearer;
pub mod origin;

use super::normal::interpolated_normal;
use super::ray::{Hit, Surface};
use crate::reference::math::{Real, Vec3};
use crate::shape::mesh;
use area::{triangle_area, triangle_point};
pub use hit::{RayShear, TriangleHit, ray_shear, triangle_hit};
pub use nearer::nearer_triangle;
pub use origin::triangle_self_distance;

/// A triangle in the scalar.
pub type Triangle<F> = mesh::Triangle<Vec3<F>>;

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
