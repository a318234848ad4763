//! A path carries L/n², as in the hand-out; twin of `shaders/bsdf/scaling/flux.glsl`.

use crate::reference::math::Real;

/// 1
pub fn transmission_scale<F: Real>(_eta: F) -> F {
    F::one()
}
