//! The throughput of a path, and where it underflows; twin of `shaders/path/throughput.glsl`.

use crate::reference::math::{Real, Vec3, max_component, mean3, min2, vec3};

/// Whether t·w underflows: some channel has light in both, and no channel has 2⁻¹²⁶ of it left (in f64 2⁻¹⁰²²).
pub fn underflows<F: Real>(t: Vec3<F>, w: Vec3<F>) -> bool {
    let both = vec3(min2(t.x, w.x), min2(t.y, w.y), min2(t.z, w.z));
    max_component(both) > F::zero() && max_component(t * w) < F::LEAST_NORMAL
}

/// `t` over its mean; 1 if the mean has underflowed.
pub fn channel_shares<F: Real>(t: Vec3<F>) -> Vec3<F> {
    let mean = mean3(t);
    if mean >= F::LEAST_NORMAL {
        t / mean
    } else {
        Vec3::one()
    }
}
