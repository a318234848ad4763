//! The most light that a surface may return, by the model alone (model.md, "Density and value").
//!
//! A micro-normal m reflects F of the light that it meets and refracts 1 − F. So the albedo of the lobes with a micro-normal is
//!
//! R + T = G1(wo)/wo.z ∫ D(m) max(0, wo·m) (F G1(wr) + (1 − F) G1(wt)) dm
//!       ≤ max G1 · G1(wo)/wo.z ∫ D(m) max(0, wo·m) dm;
//!
//! the Jacobians take wi's solid angle to m's (Walter et al. 2007, eqs. 14, 17, 20, 21). Smith's G1 is what
//! makes the right side 1 (Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, JCGT 2014, eq.
//! 16). GGX has Smith's own; Beckmann's rational one is within 3.1e-3 of it, and Phong's is far from it. To it comes Kd.

use vkpt::prepared::{Material, MaterialKind};
use vkpt::settings::Distribution;

use crate::common::facets::{excess, facets, most_g1};

/// Whether a surface of this kind has micro-normals.
fn rough(kind: MaterialKind) -> bool {
    matches!(
        kind,
        MaterialKind::Glossy | MaterialKind::RoughDielectric | MaterialKind::WeakDielectric
    )
}

/// Schlick's reflectance of an opaque material: F0 + (1 − F0)(1 − z)⁵.
fn schlick(f0: f64, z: f64) -> f64 {
    f0 + (1.0 - f0) * (1.0 - z).powi(5)
}

/// The bound of channel `c` of the albedo where light leaves along wo, z = wo.z.
pub fn albedo(m: &Material, c: usize, z: f64) -> f64 {
    let micro = match m.kind {
        MaterialKind::Black | MaterialKind::Diffuse => 0.0,
        MaterialKind::Mirror => schlick(m.f0[c], z),
        kind if rough(kind) => most_g1(m.distribution) * facets(m.distribution, m.width, z),
        _ => 1.0,
    };
    m.kd[c] + micro
}

/// The bound of the material's albedo, in any channel, for any wo: Phong's G1 is at most 1.7675 times Smith's, Beckmann's
/// 3.2e-3 more (model.md, "Distributions and shadowing"; model.md, "Energy").
pub fn albedo_anywhere(m: &Material) -> f64 {
    let micro = match (m.kind, m.distribution) {
        (MaterialKind::Black | MaterialKind::Diffuse, _) => 0.0,
        (kind, Distribution::Phong) if rough(kind) => 1.7675,
        (kind, Distribution::Beckmann) if rough(kind) => 1.0 + 3.2e-3,
        _ => 1.0,
    };
    m.kd.max_element() + micro
}

/// The bound of the mean over RGB of a sample's weight, by visible normals and choice by Fresnel.
///
/// Micro-normals are drawn as they are seen, of Phong nearly so: G1(wi) D G1(wo) wo·m/(wo.z pm) is at most [`normals`], F/F̄
/// and (1 − F)/(1 − F̄) have the mean 1, and of a mixture of lobes, (a + b)/(p q_a + (1 − p) q_b), no weight is above the larger
/// one of a/(p q_a) and b/((1 − p) q_b).
pub fn weight(m: &Material, z: f64) -> f64 {
    let kd = m.kd_mean;
    let normals = if rough(m.kind) {
        normals(m.distribution, m.width, z)
    } else {
        1.0
    };
    match m.kind {
        MaterialKind::Black => 0.0,
        MaterialKind::Diffuse => kd,
        // p = K̄d/(K̄d + F̄(wo.z)) within [.1, .9]; the renderer's wo.z is off by 1e-6 at most, relative to itself.
        MaterialKind::Glossy | MaterialKind::Mirror => {
            let seen = |z: f64| schlick((m.f0.x + m.f0.y + m.f0.z) / 3.0, z);
            let (least, most) = (seen(z * (1.0 + 1e-6)), seen(z * (1.0 - 1e-6)));
            let p = |seen: f64| (kd / (kd + seen)).clamp(0.1, 0.9);
            let micro = if m.kind == MaterialKind::Mirror {
                most
            } else {
                normals
            };
            if kd > 0.0 {
                (kd / p(most)).max(micro / (1.0 - p(least)))
            } else {
                micro
            }
        }
        // p = K̄d/(K̄d + 1)
        _ => (1.0 + kd) * normals.max(1.0),
    }
}

/// The visible part of facets, as drawn, times the largest G1(wi); the quadrature is 1e-5 off at most.
fn normals(distribution: Distribution, width: f64, z: f64) -> f64 {
    let gain = match distribution {
        Distribution::Ggx => 1.0,
        _ => facets(distribution, width, z) * (1.0 + 1e-5),
    };
    most_g1(distribution) * gain * excess(distribution, width)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::facets::g1;
    use statrs::function::erf::erf;

    const WIDTHS: [f64; 4] = [1e-4, 0.1, 0.5, 1.0];
    const COSINES: [f64; 5] = [1e-3, 0.05, 0.3, 0.8, 1.0];

    /// The quadrature by closed forms: 1 for GGX, and for Beckmann (1 + erf a)/2 + exp(−a²)/(2a√π), a = 1/(α tan θ), against the
    /// rational G1 (Walter et al. 2007, eq. 26: its reciprocal).
    #[test]
    fn the_albedo_of_facets_is_known_of_ggx_and_beckmann() {
        for (width, z) in WIDTHS.into_iter().flat_map(|w| COSINES.map(|z| (w, z))) {
            let ggx = facets(Distribution::Ggx, width, z);
            assert!(
                (ggx - 1.0).abs() < 1e-5,
                "GGX, width {width}, cos {z}: {ggx}"
            );
            let a = z / (width * ((1.0 - z) * (1.0 + z)).sqrt());
            let smith =
                0.5 * (1.0 + erf(a)) + (-a * a).exp() / (2.0 * a * std::f64::consts::PI.sqrt());
            let expected = g1(Distribution::Beckmann, width, z) * smith;
            let beckmann = facets(Distribution::Beckmann, width, z);
            assert!(
                (beckmann - expected).abs() < 1e-5,
                "Beckmann, width {width}, cos {z}: {beckmann}, {expected}"
            );
            assert!(beckmann < 1.0 + 3.2e-3);
        }
    }

    /// α_p = 0, D = 1/π: the integral is (1 + cos θ)/2, and 3.535/2 its value at the horizon.
    #[test]
    fn the_albedo_of_facets_is_known_of_phong() {
        for z in COSINES {
            let expected = g1(Distribution::Phong, 1.0, z) * 0.5 * (1.0 + z) / z;
            let phong = facets(Distribution::Phong, 1.0, z);
            assert!(
                (phong - expected).abs() < 1e-5,
                "cos {z}: {phong}, {expected}"
            );
        }
        let horizon = facets(Distribution::Phong, 1.0, 1e-6);
        assert!((horizon - 1.7675).abs() < 1e-5, "{horizon}");
        for width in WIDTHS {
            for z in COSINES {
                assert!(facets(Distribution::Phong, width, z) < 1.7675);
            }
        }
    }

    #[test]
    fn the_rational_fit_is_above_1_by_so_much() {
        let worst = (0..=160_000).map(|i| {
            let x = f64::from(i) * 1e-5;
            x * (3.535 + 2.181 * x) / (1.0 + x * (2.276 + 2.577 * x))
        });
        let worst = worst.fold(0.0, f64::max);
        assert!((6.1e-5..6.2e-5).contains(&(worst - 1.0)), "{worst}");
    }

    #[test]
    fn weights_are_those_of_the_model_page() {
        // Beckmann's G1 over Smith's; 1.7675 by the excess of Phong's law over its facets
        for (width, z) in WIDTHS.into_iter().flat_map(|w| COSINES.map(|z| (w, z))) {
            assert_eq!(normals(Distribution::Ggx, width, z), 1.0);
            assert!(normals(Distribution::Beckmann, width, z) < 1.004);
            assert!(normals(Distribution::Phong, width, z) < 1.83);
        }
        let widest = normals(Distribution::Phong, 1.0, 1e-6);
        assert!(widest > 1.82, "{widest}");
    }
}
