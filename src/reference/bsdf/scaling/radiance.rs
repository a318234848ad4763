//! A path carries radiance; twin of `shaders/bsdf/scaling/radiance.glsl`.

use crate::reference::math::Real;

/// eta²: refraction conserves L/n².
pub fn transmission_scale<F: Real>(eta: F) -> F {
    eta * eta
}
