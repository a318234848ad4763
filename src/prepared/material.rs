//! A scene's material → [`Material`]: the kind of surface (model.md, "Limits"), and every constant that depends on
//! the material alone, in f64.

use glam::DVec3;

use super::{Material, MaterialKind, OPAQUE_SIGMA, Space};
use crate::scene::{Brdf, WordLines};
use crate::settings::{Distribution, DistributionRule, Fresnel, Model};

/// Below this |ior − 1| a surface is a null interface.
const NOTHING_IOR: f64 = 1e-7;
/// Below this width a surface is perfectly smooth: the error of D at a recomputed half vector grows as 1e-8/α.
const SMOOTH_WIDTH: f64 = 1e-4;
/// The same limit as a Phong exponent: smooth above it.
const SMOOTH_EXPONENT: f64 = 2e8;
/// Below this α·|ior − 1| refraction keeps one direction; its density would be off by 1e-8/(α·|ior − 1|).
const WEAK_REFRACTION: f64 = 1e-5;
/// Least probability of reflection and of refraction by norms in a transmissive material: ‖Ks‖ : ‖Kt‖
/// alone would never draw the reflection of a glass with Ks = 0, whose Fresnel term is not 0.
const LEAST_CHOICE: f64 = 1.0 / 256.0;

/// Prepares the material of a `brdf` line. The parser ensures that colours are in [0, 1], alpha ≥ 0 and ior > 0.
pub fn material(brdf: &Brdf, model: &Model, line: usize) -> Material {
    let distribution = distribution(brdf, model);
    let alpha = parameter(distribution, brdf.alpha);
    let transmissive = brdf.kt != DVec3::ZERO;
    let ior = if transmissive { brdf.ior } else { 1.0 };
    let (p_d, p_r) = choice_by_norms(brdf);
    Material {
        kind: kind(brdf, distribution, alpha),
        distribution,
        fresnel: fresnel(brdf, model),
        kd: brdf.kd,
        kd_mean: mean(brdf.kd),
        f0: brdf.ks,
        alpha,
        width: width(distribution, alpha),
        sigma: extinction(brdf.kt, brdf.kt_length),
        radiance: DVec3::ZERO,
        eta: [1.0 / ior, ior],
        // factored, so that an ior near 1 keeps all its digits
        one_minus_eta2: [
            (ior - 1.0) * (ior + 1.0) / (ior * ior),
            (1.0 - ior) * (1.0 + ior),
        ],
        d: [
            (ior - 1.0) * (ior + 1.0),
            (1.0 - ior) * (1.0 + ior) / (ior * ior),
        ],
        p_d,
        p_r,
        line,
        words: WordLines::default(),
    }
}

/// Prepares the material of a `light` line: it emits `radiance` (W·sr⁻¹·m⁻²) and reflects nothing.
pub fn light(radiance: DVec3, line: usize) -> Material {
    Material {
        kind: MaterialKind::Black,
        distribution: Distribution::Ggx,
        fresnel: Fresnel::Schlick,
        kd: DVec3::ZERO,
        kd_mean: 0.0,
        f0: DVec3::ZERO,
        alpha: 1.0,
        width: 1.0,
        sigma: extinction(DVec3::ZERO, 1.0),
        radiance,
        eta: [1.0; 2],
        one_minus_eta2: [0.0; 2],
        d: [0.0; 2],
        p_d: 0.0,
        p_r: 0.0,
        line,
        words: WordLines::default(),
    }
}

/// The command line's choice, else the scene's, else `auto`: Phong for an exponent, GGX for a width.
fn distribution(brdf: &Brdf, model: &Model) -> Distribution {
    let auto = if brdf.alpha > 1.0 {
        Distribution::Phong
    } else {
        Distribution::Ggx
    };
    match model.distribution {
        DistributionRule::Scene => brdf.distribution.unwrap_or(auto),
        DistributionRule::Auto => auto,
        DistributionRule::Always(distribution) => distribution,
    }
}

/// The command line's choice, else the scene's, else Schlick. An opaque material has no ior for the exact form.
fn fresnel(brdf: &Brdf, model: &Model) -> Fresnel {
    if brdf.kt == DVec3::ZERO {
        Fresnel::Schlick
    } else {
        model.fresnel.or(brdf.fresnel).unwrap_or(Fresnel::Schlick)
    }
}

/// The file's alpha (> 1: an exponent, else a width) on the scale of `distribution`: α_p = 2 α_b⁻² − 2 (HO).
fn parameter(distribution: Distribution, alpha: f64) -> f64 {
    match (distribution, alpha > 1.0) {
        (Distribution::Phong, true) => alpha,
        (Distribution::Phong, false) => 2.0 / (alpha * alpha) - 2.0,
        (_, true) => (2.0 / (alpha + 2.0)).sqrt(),
        (_, false) => alpha,
    }
}

/// Width of a lobe with parameter `alpha`; for a Phong exponent the inverse of [`parameter`].
fn width(distribution: Distribution, alpha: f64) -> f64 {
    match distribution {
        Distribution::Phong => (2.0 / (alpha + 2.0)).sqrt(),
        _ => alpha,
    }
}

fn is_smooth(distribution: Distribution, alpha: f64) -> bool {
    match distribution {
        Distribution::Phong => alpha > SMOOTH_EXPONENT,
        _ => alpha < SMOOTH_WIDTH,
    }
}

fn kind(brdf: &Brdf, distribution: Distribution, alpha: f64) -> MaterialKind {
    let smooth = is_smooth(distribution, alpha);
    if brdf.kt != DVec3::ZERO {
        transmissive_kind(smooth, width(distribution, alpha), brdf.ior)
    } else if brdf.ks != DVec3::ZERO {
        match smooth {
            true => MaterialKind::Mirror,
            false => MaterialKind::Glossy,
        }
    } else if brdf.kd != DVec3::ZERO {
        MaterialKind::Diffuse
    } else {
        MaterialKind::Black
    }
}

fn transmissive_kind(smooth: bool, width: f64, ior: f64) -> MaterialKind {
    let contrast = (ior - 1.0).abs();
    if contrast < NOTHING_IOR {
        MaterialKind::NullInterface
    } else if smooth {
        MaterialKind::SmoothDielectric
    } else if width * contrast < WEAK_REFRACTION {
        MaterialKind::WeakDielectric
    } else {
        MaterialKind::RoughDielectric
    }
}

/// σ = −ln Kt / length, per channel.
fn extinction(kt: DVec3, length: f64) -> DVec3 {
    // 0 − ln 1 is +0, −ln 1 would be −0
    let sigma = |k: f64| ((0.0 - k.ln()) / length).min(OPAQUE_SIGMA);
    let channel = |k: f64| if k > 0.0 { sigma(k) } else { OPAQUE_SIGMA };
    DVec3::new(channel(kt.x), channel(kt.y), channel(kt.z))
}

/// σ per unit length of the scene, in rendering space; an opaque σ stays opaque.
pub fn extinction_in(sigma: DVec3, space: &Space) -> DVec3 {
    let opaque = DVec3::splat(OPAQUE_SIGMA);
    let scaled = (sigma * space.unit).min(opaque);
    DVec3::select(sigma.cmpeq(opaque), opaque, scaled)
}

/// The least mean of Ks and the largest width for which an opaque surface counts as concentrating light: a wall with a
/// sheen does not.
const LEAST_GLOSS: f64 = 0.1;
const WIDEST_GLOSS: f64 = 0.3;

impl Material {
    /// Whether it mirrors or refracts into few directions, and so concentrates light.
    pub fn gathers(&self) -> bool {
        use MaterialKind::{Glossy, Mirror, RoughDielectric, SmoothDielectric};
        match self.kind {
            Mirror | RoughDielectric | SmoothDielectric => true,
            Glossy => self.f0.element_sum() >= 3.0 * LEAST_GLOSS && self.width <= WIDEST_GLOSS,
            _ => false,
        }
    }

    /// Kt per unit length of the scene, as in its file.
    pub fn transmittance(&self, space: &Space) -> DVec3 {
        let scaled = self.sigma.map(|sigma| (-sigma / space.unit).exp());
        let opaque = self.sigma.cmpeq(DVec3::splat(OPAQUE_SIGMA));
        DVec3::select(opaque, DVec3::ZERO, scaled)
    }
}

/// (‖Kd‖/(‖Kd‖ + ‖Ks‖ + ‖Kt‖), ‖Ks‖/(‖Ks‖ + ‖Kt‖)) with the hand-out's Euclidean norms; 0 if there is no choice. In a
/// transmissive material the second keeps a distance of [`LEAST_CHOICE`] from both ends.
fn choice_by_norms(brdf: &Brdf) -> (f64, f64) {
    let (kd, ks, kt) = (brdf.kd.length(), brdf.ks.length(), brdf.kt.length());
    let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
    let p_r = share(ks, ks + kt);
    let p_r = if kt > 0.0 {
        p_r.clamp(LEAST_CHOICE, 1.0 - LEAST_CHOICE)
    } else {
        p_r
    };
    (share(kd, kd + ks + kt), p_r)
}

fn mean(c: DVec3) -> f64 {
    (c.x + c.y + c.z) / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Settings;

    fn brdf() -> Brdf {
        Brdf {
            kd: DVec3::ZERO,
            ks: DVec3::splat(0.04),
            alpha: 0.3,
            kt: DVec3::splat(0.9),
            kt_length: 1.0,
            ior: 1.5,
            distribution: None,
            fresnel: None,
        }
    }

    fn prepare(brdf: &Brdf) -> Material {
        material(brdf, &Settings::default().model, 1)
    }

    #[test]
    fn kinds_follow_the_limits() {
        let opaque = |kd: f64, ks: f64, alpha| Brdf {
            kd: DVec3::splat(kd),
            ks: DVec3::splat(ks),
            alpha,
            kt: DVec3::ZERO,
            ..brdf()
        };
        let glass = |alpha, ior| Brdf {
            alpha,
            ior,
            ..brdf()
        };
        for (b, expected) in [
            (opaque(0.0, 0.0, 0.3), MaterialKind::Black),
            (opaque(0.5, 0.0, 0.0), MaterialKind::Diffuse),
            (opaque(0.5, 0.5, 0.3), MaterialKind::Glossy),
            (opaque(0.5, 0.5, 0.0), MaterialKind::Mirror),
            (opaque(0.0, 0.5, 2e8), MaterialKind::Glossy),
            (opaque(0.0, 0.5, 2.1e8), MaterialKind::Mirror),
            (glass(0.3, 1.5), MaterialKind::RoughDielectric),
            (glass(1e-4, 1.5), MaterialKind::RoughDielectric),
            (glass(0.99e-4, 1.5), MaterialKind::SmoothDielectric),
            (glass(0.0, 0.7), MaterialKind::SmoothDielectric),
            (glass(0.1, 1.0 + 0.9e-4), MaterialKind::WeakDielectric),
            (glass(0.1, 1.0 - 1.1e-4), MaterialKind::RoughDielectric),
            (glass(0.1, 1.0 + 0.9e-7), MaterialKind::NullInterface),
            (glass(0.0, 1.0), MaterialKind::NullInterface),
        ] {
            assert_eq!(prepare(&b).kind, expected, "{b:?}");
        }
    }

    #[test]
    fn alpha_above_one_is_an_exponent_and_converts_both_ways() {
        let of = |alpha, distribution| {
            let m = prepare(&Brdf {
                alpha,
                distribution,
                ..brdf()
            });
            (m.distribution, m.alpha, m.width)
        };
        assert_eq!(of(0.5, None), (Distribution::Ggx, 0.5, 0.5));
        assert_eq!(of(1.0, None).0, Distribution::Ggx);
        assert_eq!(of(6.0, None), (Distribution::Phong, 6.0, 0.5));
        // 2/0.5² − 2 = 6
        let phong = Some(Distribution::Phong);
        assert_eq!(of(0.5, phong), (Distribution::Phong, 6.0, 0.5));
        let beckmann = Some(Distribution::Beckmann);
        assert_eq!(of(6.0, beckmann), (Distribution::Beckmann, 0.5, 0.5));
    }

    #[test]
    fn a_flag_beats_a_word_of_the_scene() {
        let mut model = Settings::default().model;
        let b = Brdf {
            distribution: Some(Distribution::Phong),
            fresnel: Some(Fresnel::Schlick),
            ..brdf()
        };
        model.distribution = DistributionRule::Auto;
        assert_eq!(material(&b, &model, 1).distribution, Distribution::Ggx);
        model.distribution = DistributionRule::Always(Distribution::Beckmann);
        model.fresnel = Some(Fresnel::Exact);
        let m = material(&b, &model, 1);
        assert_eq!(m.distribution, Distribution::Beckmann);
        assert_eq!(m.fresnel, Fresnel::Exact);
        let opaque = Brdf {
            kt: DVec3::ZERO,
            ..b
        };
        assert_eq!(material(&opaque, &model, 1).fresnel, Fresnel::Schlick);
    }

    #[test]
    fn constants_of_the_interface_keep_their_digits() {
        // 2⁻²⁰ is exact, so 1 − n⁻² = (2h + h²)/(1 + h)² is known to the last digit
        let h = 2f64.powi(-20);
        let m = prepare(&Brdf {
            ior: 1.0 + h,
            ..brdf()
        });
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 4e-16, "{a} is not {b}");
        close(m.d[0], 2.0 * h + h * h);
        close(m.one_minus_eta2[1], -(2.0 * h + h * h));
        close(
            m.one_minus_eta2[0],
            (2.0 * h + h * h) / ((1.0 + h) * (1.0 + h)),
        );
        close(m.d[1], -m.one_minus_eta2[0]);
        close(m.eta[0] * m.eta[1], 1.0);
    }

    #[test]
    fn extinction_is_finite_and_signed() {
        let m = prepare(&Brdf {
            kt: DVec3::new(1.0, 0.5, 0.0),
            ..brdf()
        });
        assert!(m.sigma.x == 0.0 && m.sigma.x.is_sign_positive());
        assert_eq!(m.sigma.y, std::f64::consts::LN_2);
        assert_eq!(m.sigma.z, OPAQUE_SIGMA);
    }

    #[test]
    fn choices_by_norms_never_starve_a_lobe() {
        let m = prepare(&Brdf {
            kd: DVec3::splat(0.5),
            ks: DVec3::splat(0.3),
            kt: DVec3::splat(0.2),
            ..brdf()
        });
        assert!((m.p_d - 0.5).abs() < 1e-15 && (m.p_r - 0.6).abs() < 1e-15);
        let m = prepare(&Brdf {
            ks: DVec3::ZERO,
            ..brdf()
        });
        assert_eq!((m.p_d, m.p_r), (0.0, LEAST_CHOICE));
    }

    #[test]
    fn a_light_only_emits() {
        let m = light(DVec3::splat(5.0), 3);
        assert_eq!(m.kind, MaterialKind::Black);
        assert_eq!((m.radiance, m.line), (DVec3::splat(5.0), 3));
        assert!(m.kd == DVec3::ZERO && m.f0 == DVec3::ZERO);
    }
}
