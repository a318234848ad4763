//! Meshes as lights; twin of `shaders/light/mesh.glsl`.

use super::choice::{cdf_choice, cdf_probability};
use super::sample::{LightSample, area_density, area_sample, solid_angle_pdf};
use crate::reference::math::{Real, Vec3};
use crate::reference::shape::Triangle;
use crate::reference::shape::triangle::area::{triangle_area, triangle_sample};

/// A point of a mesh: the triangle by `u24` < 2²⁴ from the mesh's own n + 1 entries `cdf`, then a point
/// uniform in it. `first` is the mesh's first triangle among all, `triangles`.
///
/// Both faces of a triangle emit. No triangle is excluded for facing away: whether another part of the mesh is in front
/// of the point is left to the shadow ray.
pub fn mesh_light_sample<F: Real>(
    p: Vec3<F>,
    triangles: &[Triangle<F>],
    first: u32,
    cdf: &[u32],
    u24: u32,
    u: [F; 2],
) -> LightSample<F> {
    let i = cdf_choice(cdf, u24);
    let [v0, v1, v2] = triangles[(first + i) as usize].v;
    let surface = triangle_area(v0, v1, v2);
    let point = triangle_sample(v0, v1, v2, u);
    let density = cdf_probability::<F>(cdf, i) * area_density(surface.area);
    area_sample(point - p, surface.ng, density, first + i)
}

/// Density of `mesh_light_sample` at a point of triangle `prim` that a path has hit at `distance` with the cosine
/// `cosine` = |N_L·w|.
pub fn mesh_light_pdf<F: Real>(
    triangles: &[Triangle<F>],
    first: u32,
    cdf: &[u32],
    prim: u32,
    distance: F,
    cosine: F,
) -> F {
    let [v0, v1, v2] = triangles[prim as usize].v;
    let area = triangle_area(v0, v1, v2).area;
    let density = cdf_probability::<F>(cdf, prim - first) * area_density(area);
    solid_angle_pdf(density, distance, cosine)
}
