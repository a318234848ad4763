//! Where f32 ends for a path; twin of `shaders/path/throughput.glsl`.

use crate::reference::math::{Real, Vec3, max_component, min2, vec3};

/// Whether t·w underflows: some channel has light in both, and no channel has 2⁻¹²⁶ of it left (in f64 2⁻¹⁰²²).
pub fn underflows<F: Real>(t: Vec3<F>, w: Vec3<F>) -> bool {
    let both = vec3(min2(t.x, w.x), min2(t.y, w.y), min2(t.z, w.z));
    max_component(both) > F::zero() && max_component(t * w) < F::LEAST_NORMAL
}
