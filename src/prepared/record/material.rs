//! Materials, with every constant that depends on them alone.

use crate::scene::WordLines;
use crate::settings::{Distribution, Fresnel};

/// The interaction of a surface with light; one file of `bsdf/` each.
///
/// The order counts: kinds before [`MaterialKind::RoughDielectric`] are opaque, those from it on transmit
/// (`bsdf/choice/fresnel` of both renderers compares with it).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u32)]
pub enum MaterialKind {
    /// Emits or absorbs; ends every path.
    Black = 0,
    /// Kd only.
    Diffuse = 1,
    /// Opaque: rough reflection, Kd possible.
    Glossy = 2,
    /// Opaque: perfect mirror, Kd possible.
    Mirror = 3,
    /// Rough reflection and rough transmission, Kd possible.
    RoughDielectric = 4,
    /// Smooth reflection and smooth transmission, Kd possible.
    SmoothDielectric = 5,
    /// Rough reflection, transmission that keeps one direction: α·|n − 1| < 1e-5. Kd possible.
    WeakDielectric = 6,
    /// |ior − 1| < 1e-7: light passes straight through.
    NullInterface = 7,
}

const _: () = {
    use MaterialKind::{Black, Diffuse, Glossy, Mirror, NullInterface, RoughDielectric};
    use MaterialKind::{SmoothDielectric, WeakDielectric};
    let transmits = RoughDielectric as u32;
    assert!((Black as u32) < transmits && (Diffuse as u32) < transmits);
    assert!((Glossy as u32) < transmits && (Mirror as u32) < transmits);
    assert!(SmoothDielectric as u32 > transmits && WeakDielectric as u32 > transmits);
    assert!(NullInterface as u32 > transmits);
};

impl MaterialKind {
    pub const EVERY: [Self; 8] = [
        Self::Black,
        Self::Diffuse,
        Self::Glossy,
        Self::Mirror,
        Self::RoughDielectric,
        Self::SmoothDielectric,
        Self::WeakDielectric,
        Self::NullInterface,
    ];
}

crate::layout::record! {
    /// A material. Pairs have the outer side first: for `wo` outside, inside.
    pub struct Material<F> {
        /// Diffuse reflectance.
        kd: vec3,
        /// Mean of Kd over RGB.
        kd_mean: float,
        /// Reflectance at normal incidence for Schlick: Ks.
        f0: vec3,
        /// Parameter of the distribution: width, or Phong's exponent.
        alpha: float,
        /// −ln Kt per unit length of rendering space; `OPAQUE_SIGMA` where Kt = 0 in a channel.
        sigma: vec3,
        /// Width: for Phong √(2/(exponent + 2)).
        width: float,
        /// Emitted radiance, W·sr⁻¹·m⁻².
        radiance: vec3,
        /// Probability of the diffuse lobe by norms: ‖Kd‖ / (‖Kd‖ + ‖Ks‖ + ‖Kt‖).
        p_d: float,
        /// n_o / n_i.
        eta: vec2,
        /// 1 − eta².
        one_minus_eta2: vec2,
        /// (n_i / n_o)² − 1 = (1 − eta²) / eta².
        d: vec2,
        /// Probability of reflection once the micro-normal is drawn, by norms: ‖Ks‖ / (‖Ks‖ + ‖Kt‖).
        p_r: float,
        /// `prepared::MaterialKind`.
        kind: uint as MaterialKind,
        /// `settings::Distribution`.
        distribution: uint as Distribution,
        /// `settings::Fresnel`.
        fresnel: uint as Fresnel,
        (pad0: uint),
        (pad1: uint),
    } and {
        /// The scene file's line, 0 for the default material.
        pub line: usize,
        /// The lines of the words that apply to it.
        pub words: WordLines,
    }
}

/// σ of a channel with Kt = 0: finite, so that no product is NaN, and black after 1e-28 units. It is the largest σ.
pub const OPAQUE_SIGMA: f64 = 1e30;
