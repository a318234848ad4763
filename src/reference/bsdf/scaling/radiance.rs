//! A path carries radiance; twin of `shaders/bsdf/scaling/radiance.glsl`.

use crate::reference::math::Real;

/// eta²: L/n² is what refraction keeps.
pub fn transmission_scale<F: Real>(eta: F) -> F {
    eta * eta
}
