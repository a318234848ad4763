//! Shading normals of meshes that give any; twin of `shaders/shape/normal/smooth.glsl`.

use crate::reference::math::{Real, Vec3, dot3, length3};

/// The corners' normals by the hit's weights `uv` of the second and third (Phong, Illumination for Computer
/// Generated Pictures, 1975), turned to the side of `ng`; `ng` where they are 0.
pub fn interpolated_normal<F: Real>(
    n0: Vec3<F>,
    n1: Vec3<F>,
    n2: Vec3<F>,
    uv: [F; 2],
    ng: Vec3<F>,
) -> Vec3<F> {
    let n = n0 * (F::one() - uv[0] - uv[1]) + n1 * uv[0] + n2 * uv[1];
    let length = length3(n);
    let flat = length == F::zero();
    let unit = n / if flat { F::one() } else { length };
    if flat {
        ng
    } else if dot3(unit, ng) < F::zero() {
        -unit
    } else {
        unit
    }
}
