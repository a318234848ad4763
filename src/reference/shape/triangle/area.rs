//! Points, normal and area of a triangle; twin of `shaders/shape/triangle/area.glsl`.

use crate::reference::math::{Real, Vec3, cross3, length3, max_component, max2, vec3};

/// Unit normal of a triangle, and its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleArea<F> {
    pub ng: Vec3<F>,
    pub area: F,
}

/// |x|, |y|, |z|
pub fn abs3<F: Real>(v: Vec3<F>) -> Vec3<F> {
    vec3(v.x.abs(), v.y.abs(), v.z.abs())
}

/// v₀ + (u e₁ + v e₂): only one rounding has the size of the coordinates.
pub fn triangle_point<F: Real>(v0: Vec3<F>, v1: Vec3<F>, v2: Vec3<F>, uv: [F; 2]) -> Vec3<F> {
    v0 + ((v1 - v0) * uv[0] + (v2 - v0) * uv[1])
}

/// A point uniform in the triangle: the square folded onto it, √u₁ is the share of the way from v₀ to its opposite edge.
pub fn triangle_sample<F: Real>(v0: Vec3<F>, v1: Vec3<F>, v2: Vec3<F>, u: [F; 2]) -> Vec3<F> {
    let s = u[0].sqrt();
    triangle_point(v0, v1, v2, [s * (F::one() - u[1]), s * u[1]])
}

/// e₁ × e₂ = 2·area·ng, for edges scaled to a size of 1, so that neither small nor large ones leave the range of `F`. A
/// triangle without area gets area 0 and the normal (0, 0, 1).
pub fn triangle_area<F: Real>(v0: Vec3<F>, v1: Vec3<F>, v2: Vec3<F>) -> TriangleArea<F> {
    let e1 = v1 - v0;
    let e2 = v2 - v0;
    let size = max2(max_component(abs3(e1)), max_component(abs3(e2)));
    let scale = F::one() / if size == F::zero() { F::one() } else { size };
    let n = cross3(e1 * scale, e2 * scale);
    let length = length3(n);
    let empty = length == F::zero();
    let unit = n / if empty { F::one() } else { length };
    TriangleArea {
        ng: if empty {
            vec3(F::zero(), F::zero(), F::one())
        } else {
            unit
        },
        area: F::new(0.5) * length * size * size,
    }
}
