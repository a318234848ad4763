//! Weights of light that is found in two ways; twin of `shaders/integrator/path/connect/`.

use super::pick::candidate::Weigh;
use crate::reference::light::LightSample;
use crate::reference::math::Real;
use crate::settings::Connect;

/// The power heuristic with exponent 2, w = p²/(p² + q²), written 1/(1 + (q/p)²) against overflow.
///
/// Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, section 9.2.4.
pub fn power_heuristic<F: Real>(p: F, q: F) -> F {
    let ratio = q / p;
    F::one() / (F::one() + ratio * ratio)
}

/// Weight of light found by a connection.
pub fn connection_weight<F: Real>(connect: Connect, light_pdf: F, bsdf_pdf: F) -> F {
    match connect {
        Connect::Mis => power_heuristic(light_pdf, bsdf_pdf),
        Connect::Light => F::one(),
        Connect::Bsdf => F::zero(),
    }
}

impl<F: Real> Weigh<F> for Connect {
    fn weight(&self, _: usize, _: &LightSample<F>, p: F, bsdf_pdf: F) -> F {
        connection_weight(*self, p, bsdf_pdf)
    }
}

/// Weight of light found by a hit; no connection could have found the light that a delta lobe or the camera sees.
pub fn hit_weight<F: Real>(connect: Connect, delta: bool, bsdf_pdf: F, light_pdf: F) -> F {
    match connect {
        Connect::Bsdf => F::one(),
        _ if delta => F::one(),
        Connect::Mis => power_heuristic(bsdf_pdf, light_pdf),
        Connect::Light => F::zero(),
    }
}
