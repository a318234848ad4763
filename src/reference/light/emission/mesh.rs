//! Points of meshes; twin of `shaders/light/emission/mesh.glsl`.

use super::Emission;
use crate::reference::light::choice::{cdf_choice, cdf_probability};
use crate::reference::light::sample::area_density;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::shape::Triangle;
use crate::reference::shape::triangle::area::{triangle_area, triangle_sample};

/// The triangle by `u24` < 2²⁴ from the mesh's own n + 1 entries `cdf`, then a point uniform in it. `first` is the
/// mesh's first triangle among all, `triangles`.
pub fn mesh_emission<F: Real>(
    triangles: &[Triangle<F>],
    first: u32,
    cdf: &[u32],
    u24: u32,
    u: [F; 2],
) -> Emission<F> {
    let i = cdf_choice(cdf, u24);
    let [v0, v1, v2] = triangles[(first + i) as usize].v;
    let surface = triangle_area(v0, v1, v2);
    Emission {
        p: triangle_sample(v0, v1, v2, u),
        n: surface.ng,
        area_pdf: cdf_probability::<F>(cdf, i) * area_density(surface.area),
        prim: first + i,
    }
}

/// Density per area of `mesh_emission` at a point of triangle `prim` that is seen along `wi`; 0 on the back, where no
/// light path goes.
pub fn mesh_emission_pdf<F: Real>(
    triangles: &[Triangle<F>],
    first: u32,
    cdf: &[u32],
    prim: u32,
    wi: Vec3<F>,
) -> F {
    let [v0, v1, v2] = triangles[prim as usize].v;
    let surface = triangle_area(v0, v1, v2);
    if dot3(wi, surface.ng) < F::zero() {
        cdf_probability::<F>(cdf, prim - first) * area_density(surface.area)
    } else {
        F::zero()
    }
}
