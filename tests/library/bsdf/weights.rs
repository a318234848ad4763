//! Identities of weights and densities, for any weight; bounds; the hand-out's own density.

use std::f64::consts::PI;

use glam::DVec3;
use statrs::function::erf::erf;
use vkpt::prepared::MaterialKind;
use vkpt::reference::bsdf::distribution::beckmann::beckmann_g1;
use vkpt::reference::bsdf::distribution::ggx::ggx_g1;
use vkpt::reference::bsdf::normals::normals_pdf;
use vkpt::reference::bsdf::reflection::reflection_half_vector;
use vkpt::reference::bsdf::snell::total_reflection;
use vkpt::reference::bsdf::{LOBE_DELTA, LOBE_NONE, LOBE_TRANSMISSION, bsdf_eval, bsdf_sample};
use vkpt::reference::math::{Real, Vec3, dot3};
use vkpt::settings::{Distribution, Fresnel, LobeChoice, Normals, Settings};

use super::support::albedo::flux;
use super::support::random::{Random, random};
use super::support::surface::{
    DISTRIBUTIONS, ESTIMATORS, dielectric, direction, estimator, opaque, parameter, seen,
};

/// The largest |value·cos/pdf − weight|, relative to 1 and over all channels, of samples of rough surfaces, coloured
/// ones, with Kd and without, of either Fresnel term (model.md, "Weight against value and density").
fn weight_error<F: Real>(least_width: f64) -> f64 {
    let mut r = Random::new(3);
    let mut largest = 0.0f64;
    for i in 0..40_000 {
        let distribution = DISTRIBUTIONS[i % 3];
        let (lobe, normals) = ESTIMATORS[i % 4];
        let settings = estimator(lobe, normals);
        let alpha = parameter(distribution, least_width.powf(r.unit()));
        let colour = DVec3::new(0.6, 0.2, 0.05);
        let mut m = if i % 5 == 0 {
            opaque(distribution, alpha, DVec3::splat(0.3), colour)
        } else {
            dielectric(distribution, alpha, [1.1, 1.5, 2.5, 1.0 / 1.5][i % 4])
        };
        (m.f0, m.p_r) = (colour, 0.4);
        if i % 7 < 3 && i % 5 != 0 {
            m.fresnel = Fresnel::Schlick;
        }
        if i % 11 < 4 {
            (m.kd, m.kd_mean, m.p_d) = (DVec3::new(0.1, 0.2, 0.6), 0.3, 0.3);
        }
        let wo = Vec3::<F>::new(direction(1.0 - 0.95 * r.unit(), 6.0 * r.unit()).f64());
        let at = seen(&m, r.unit() < 0.5, wo);
        let mut u = || F::new(r.unit());
        let s = bsdf_sample(&settings, &at, random(u(), u(), [u(), u()], [u(), u()]));
        let e = bsdf_eval(&settings, &at, s.wi);
        if s.lobe != LOBE_NONE && e.pdf > F::zero() {
            let (ratio, weight) = (e.value.f64() / e.pdf.f64(), s.weight.f64());
            let off = (ratio - weight).abs() / (DVec3::ONE + weight);
            largest = largest.max(off.max_element());
        }
    }
    largest
}

#[test]
fn value_over_density_is_the_weight() {
    // the recomputed half vector is 1e-16/(α·|n − 1|) off, and the excess of Phong's law with it
    let f64_error = weight_error::<f64>(0.05);
    assert!(f64_error < 1e-13, "{f64_error:e}");
    let f32_error = weight_error::<f32>(1e-3);
    assert!(f32_error < 1e-3, "{f32_error:e}");
    // the comparison sees the effect of rounding: a planted error of that size would be seen
    assert!(f32_error > 1e-7);
}

/// Visible GGX normals and choice by Fresnel: the weight is G1(wi) F/F̄ or G1(wi)(1 − F)/(1 − F̄), never above 1.
#[test]
fn weights_of_visible_ggx_are_g1() {
    let mut r = Random::new(4);
    let mut settings = Settings::default();
    settings.model.radiance_scaling = false;
    for i in 0..20_000 {
        let m = dielectric(Distribution::Ggx, [0.05, 0.3, 1.0][i % 3], 1.5);
        let at = seen(&m, i % 2 == 0, direction(r.unit(), 6.0 * r.unit()));
        let s = bsdf_sample(
            &settings,
            &at,
            random(r.unit(), r.unit(), r.pair(), r.pair()),
        );
        if s.lobe != LOBE_NONE {
            let g1 = ggx_g1(s.wi, m.alpha);
            assert!((s.weight.x - g1).abs() < 1e-12, "{s:?}");
        }
    }
}

/// Visible normals of Beckmann: the same, except for the model's G1(wo) over Smith's, within 3.3e-3 of 1.
#[test]
fn weights_of_visible_beckmann_are_g1() {
    let mut r = Random::new(5);
    let settings = flux(LobeChoice::Fresnel, Normals::Visible);
    let mut largest = 0.0f64;
    for i in 0..20_000 {
        let m = dielectric(Distribution::Beckmann, [0.05, 0.3, 1.0][i % 3], 1.5);
        let at = seen(&m, i % 2 == 0, direction(r.unit(), 6.0 * r.unit()));
        let s = bsdf_sample(
            &settings,
            &at,
            random(r.unit(), r.unit(), r.pair(), r.pair()),
        );
        // 2/(1 + erf a + e^(−a²)/(a√π)) (Walter et al. 2007, after eq. 26)
        let a = at.wo.z / (m.alpha * (at.wo.x.hypot(at.wo.y)));
        let smith = 2.0 / (1.0 + erf(a) + (-a * a).exp() / (a * PI.sqrt()));
        if s.lobe != LOBE_NONE {
            let gain = beckmann_g1(at.wo, m.alpha) / smith;
            let off = s.weight.x / (gain * beckmann_g1(s.wi, m.alpha)) - 1.0;
            // statrs knows erf to 1e-10
            assert!(off.abs() < 1e-9, "{s:?}, {off:e}");
            largest = largest.max(s.weight.x);
        }
    }
    assert!(largest < 1.0033 && largest > 1.003, "{largest}");
}

/// A weak interface is the rough one whose transmission is not connected to lights: same directions, same weights.
#[test]
fn a_weak_interface_joins_the_rough_one() {
    let settings = Settings::default();
    let mut r = Random::new(10);
    for i in 0..5_000 {
        let d = DISTRIBUTIONS[i % 3];
        let m = dielectric(d, parameter(d, 0.3), 1.0 + 3e-5);
        assert_eq!(m.kind, MaterialKind::WeakDielectric);
        let weak = seen(&m, i % 2 == 0, direction(r.unit(), 0.3));
        let mut rough = weak;
        rough.material.kind = MaterialKind::RoughDielectric;
        let (lobe, reflect, um, ud) = (r.unit(), r.unit() * 1e-9, r.pair(), r.pair());
        for u_reflect in [reflect, 0.5] {
            let s = bsdf_sample(&settings, &weak, random(lobe, u_reflect, um, ud));
            let t = bsdf_sample(&settings, &rough, random(lobe, u_reflect, um, ud));
            assert_eq!((s.wi, s.lobe & !LOBE_DELTA), (t.wi, t.lobe));
            let off = (s.weight - t.weight).f64().abs().max_element();
            assert!(off < 1e-9 * (1.0 + t.weight.x), "{s:?} {t:?}");
            assert_eq!(
                s.lobe & LOBE_DELTA != 0,
                s.lobe & !LOBE_DELTA == LOBE_TRANSMISSION
            );
        }
    }
}

/// The density by norms is p_d wi_z/π + (p_r + [TIR] p_t) pm J, in the hand-out's own probabilities (model.md,
/// "Density and value").
#[test]
fn density_by_norms_is_the_handouts() {
    let (p_d, p_r, p_t) = (0.3, 0.7 * 0.4, 0.7 * 0.6);
    let mut m = dielectric(Distribution::Ggx, 0.4, 1.5);
    (m.kd, m.kd_mean, m.p_d, m.p_r) = (DVec3::splat(0.5), 0.5, p_d, 0.4);
    let settings = Settings::handout();
    let mut r = Random::new(8);
    let mut total = 0;
    for _ in 0..5_000 {
        let (wo, wi) = (
            direction(r.unit(), 0.0),
            direction(r.unit(), 6.3 * r.unit()),
        );
        let at = seen(&m, false, wo);
        let half = reflection_half_vector(wo, wi);
        let c = dot3(wo, half);
        let tir = at.eta * at.eta * (1.0 - c * c) > 1.0;
        assert_eq!(tir, total_reflection(&at, c));
        let chosen = p_r + if tir { p_t } else { 0.0 };
        let expected = p_d * wi.z / PI + chosen * normals_pdf(&settings, &at, half) / (4.0 * c);
        let found = bsdf_eval(&settings, &at, wi).pdf;
        assert!(
            (found - expected).abs() < 1e-13 * expected,
            "{found} {expected}"
        );
        total += usize::from(tir);
    }
    assert!(total > 500);
}
