//! Triangles of meshes; twin of `shaders/shape/triangle.glsl` and `shaders/shape/triangle/`.

pub mod area;
pub mod hit;
pub mod nearer;

use super::normal::{shading_normal_flat, shading_normal_smooth};
use super::ray::{Hit, Surface};
use crate::prepared;
use crate::reference::math::{Real, Vec3};
use area::triangle_area;
pub use hit::{RayShear, TriangleHit, ray_shear, triangle_hit};
pub use nearer::{nearer_triangle, triangle_self_distance};

/// Three corners, counter-clockwise as seen from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<F> {
    pub v: [Vec3<F>; 3],
    pub shape: u32,
}

impl<F: Real> Triangle<F> {
    pub fn new(t: &prepared::Triangle) -> Self {
        Self {
            v: t.v.map(Vec3::new),
            shape: t.shape,
        }
    }
}

/// v₀ + (u e₁ + v e₂): what is rounded at the size of the coordinates is rounded once.
pub fn triangle_point<F: Real>(v0: Vec3<F>, v1: Vec3<F>, v2: Vec3<F>, uv: [F; 2]) -> Vec3<F> {
    v0 + ((v1 - v0) * uv[0] + (v2 - v0) * uv[1])
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
            Some(n) => shading_normal_smooth(n[0], n[1], n[2], hit.uv, ng),
            None => shading_normal_flat(ng),
        },
    }
}
