//! Choice of lobe by ‖Kd‖ : ‖Ks‖ : ‖Kt‖, as in the hand-out; twin of `shaders/bsdf/choice/norms.glsl`.

use crate::reference::bsdf::interaction::Interaction;
use crate::reference::bsdf::snell::total_reflection;
use crate::reference::math::Real;
use crate::reference::sampler::chance;

/// p_d = ‖Kd‖/(‖Kd‖ + ‖Ks‖ + ‖Kt‖), rounded to a probability that can be drawn
pub fn diffuse_probability<F: Real>(at: &Interaction<F>) -> F {
    chance(at.material.p_d)
}

/// R = ‖Ks‖/(‖Ks‖ + ‖Kt‖), which is 1 for opaque materials; 1 where refraction is not possible.
pub fn reflect_probability<F: Real>(at: &Interaction<F>, c: F, _f_mean: F) -> F {
    if total_reflection(at, c) {
        F::one()
    } else {
        at.material.p_r
    }
}
