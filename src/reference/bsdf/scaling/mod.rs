//! The quantity that a refracted path carries, radiance or flux (model.md, "Radiance scaling"); the kernels' slot `<scaling>`.

pub mod flux;
pub mod radiance;

use crate::reference::math::Real;
use crate::settings::Settings;

/// Factor of E_t; eta = n_o/n_i.
pub fn transmission_scale<F: Real>(settings: &Settings, eta: F) -> F {
    if settings.model.radiance_scaling {
        radiance::transmission_scale(eta)
    } else {
        flux::transmission_scale(eta)
    }
}
