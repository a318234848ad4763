//! Chooses the integrator for a scene, only from its content.

use crate::prepared::cdf::CDF_TOTAL;
use crate::prepared::{Light, Prepared};
use crate::settings::{Absorption, Connect, Integrator, Settings};

/// An integrator and the reason for it: words that complete "it was chosen: …".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chosen {
    pub integrator: Integrator,
    pub why: &'static str,
}

/// A light whose share of all directions is smaller, as seen from the shapes that concentrate its light, is hit by few
/// paths from the eye. A room whose light fills .7 % gains from paths from both ends; the course's, with 3 %, loses.
const SMALL: f64 = 0.01;

/// Paths from both ends if small lights illuminate shapes that concentrate light, otherwise paths from the eye
/// (`docs/records/2026-11-29-auto.md`).
pub fn chosen(prepared: &Prepared, settings: &Settings) -> Chosen {
    let path = |why| Chosen {
        integrator: Integrator::Path,
        why,
    };
    match () {
        () if settings.model.absorption == Absorption::Term => {
            path("--absorption term has no adjoint for light paths")
        }
        () if settings.estimator.connect != Connect::Mis => {
            path("--connect applies only to paths from the eye")
        }
        () if !prepared.lights.iter().any(|l| !l.kind.is_outside()) => path("no shape is a light"),
        () if background_share(prepared) > 0.5 => {
            path("most light comes from the background, which paths from the eye find")
        }
        () if prepared.aims.is_empty() => path("nothing mirrors or refracts"),
        () if prepared.light_share.is_some_and(|share| share >= SMALL) => {
            path("the lights are large, and paths from the eye hit them")
        }
        () => Chosen {
            integrator: Integrator::Bidirectional,
            why: "small lights illuminate mirrors or glass",
        },
    }
}

/// The background's share of the power of all lights, from their sampling probabilities.
fn background_share(prepared: &Prepared) -> f64 {
    let of = |(i, light): (usize, &Light)| match light.kind.is_outside() {
        true => prepared.light_cdf[i + 1] - prepared.light_cdf[i],
        false => 0,
    };
    let drawn: u32 = prepared.lights.iter().enumerate().map(of).sum();
    f64::from(drawn) / f64::from(CDF_TOTAL)
}
