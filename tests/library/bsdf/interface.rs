//! Identities of an interface: reciprocity, energy, one Fresnel term for both sides, absorption by `term`.

use glam::DVec3;
use vkpt::reference::bsdf::distribution::distribution_d;
use vkpt::reference::bsdf::fresnel::fresnel;
use vkpt::reference::bsdf::snell::total_reflection;
use vkpt::reference::bsdf::{
    Interaction, LOBE_DELTA, LOBE_NONE, LOBE_TRANSMISSION, bsdf_eval, bsdf_sample,
};
use vkpt::reference::math::{Vec3, dot3, vec3};
use vkpt::settings::{Distribution, Fresnel, LobeChoice, Normals, Settings};

use super::support::quadrature::integrate;
use super::support::random::{Random, random};
use super::support::surface::{
    DISTRIBUTIONS, dielectric, direction, estimator, opaque, parameter, seen,
};

/// Hemispherical reflectance of a smooth interface, ∫ F 2c dc; the critical angle is an end of the quadrature.
fn hemispherical(at: &Interaction<f64>) -> f64 {
    let f = |c: f64| fresnel(at, c).x * 2.0 * c;
    // one_minus_eta2 + (eta c)² = 0
    let critical = (-at.one_minus_eta2 / (at.eta * at.eta)).max(0.0).sqrt();
    integrate([0.0, critical], 64, f) + integrate([critical, 1.0], 4096, f)
}

/// 1 − R_in = (1 − R_out)/n², for exact Fresnel and for Schlick with the cosine on the rarer side (model.md,
/// "Both sides of a smooth interface").
#[test]
fn the_two_sides_of_a_smooth_interface_agree() {
    for (kind, n) in [
        (Fresnel::Exact, 1.5),
        (Fresnel::Schlick, 1.5),
        (Fresnel::Exact, 2.5),
        (Fresnel::Exact, 1.0 / 1.5),
        (Fresnel::Schlick, 1.0 / 1.5),
    ] {
        let mut m = dielectric(Distribution::Ggx, 0.3, n);
        m.fresnel = kind;
        let wo = direction(1.0, 0.0);
        let (out, inside) = (
            hemispherical(&seen(&m, true, wo)),
            hemispherical(&seen(&m, false, wo)),
        );
        assert!(
            (1.0 - inside - (1.0 - out) / (n * n)).abs() < 1e-6,
            "{kind:?} {n}"
        );
        if (kind, n) == (Fresnel::Exact, 1.5) {
            assert!((out - 0.09178).abs() < 5e-6, "{out}");
            assert!((inside - 0.59635).abs() < 5e-6, "{inside}");
        }
    }
}

/// One F serves both directions through an interface: F(c) outside is F(√r) inside.
#[test]
fn fresnel_is_the_same_from_both_sides() {
    for kind in [Fresnel::Exact, Fresnel::Schlick] {
        let mut m = dielectric(Distribution::Ggx, 0.3, 1.5);
        m.fresnel = kind;
        let at = |outside| seen(&m, outside, direction(1.0, 0.0));
        for i in 1..=100 {
            let c = f64::from(i) / 100.0;
            let refracted = (1.0 - (1.0 - c * c) / 2.25).sqrt();
            let (front, back) = (fresnel(&at(true), c).x, fresnel(&at(false), refracted).x);
            // seen from inside, r = 1 − eta²(1 − c²) ≈ c² has lost the digits that 1 and eta² share
            let tolerance = 1e-15 / (c * c);
            assert!(
                (front - back).abs() < tolerance,
                "{kind:?} {c}: {front} {back}"
            );
        }
        // normal incidence: ((n − 1)/(n + 1))², or Ks; beyond the critical angle 1
        assert!((fresnel(&at(true), 1.0).x - 0.04).abs() < 1e-15);
        assert_eq!(fresnel(&at(false), 0.745).x, 1.0);
        assert!(fresnel(&at(false), 0.7454).x < 1.0);
    }
}

/// Smooth: R + T = 1 from both sides, at any angle, by either choice of lobe (model.md, "Energy").
#[test]
fn a_smooth_interface_keeps_all_energy() {
    for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
        for (i, c) in [1e-3, 0.1, 0.5, 0.745, 0.746, 0.9, 1.0]
            .into_iter()
            .enumerate()
        {
            for lobe in [LobeChoice::Fresnel, LobeChoice::Norms] {
                let mut settings = estimator(lobe, Normals::Visible);
                settings.model.radiance_scaling = false;
                let mut m = dielectric(Distribution::Ggx, 0.0, 1.5);
                m.fresnel = fresnel;
                let at = seen(&m, i % 2 == 0, direction(c, 0.3));
                let sample = |u| bsdf_sample(&settings, &at, random(0.5, u, [0.5; 2], [0.5; 2]));
                let (a, b) = (sample(0.0), sample(1.0 - f64::EPSILON));
                assert!(a.lobe & LOBE_DELTA != 0 && b.lobe & LOBE_DELTA != 0);
                let mut sum = a.weight.x * a.pdf;
                if b.wi.z < 0.0 {
                    sum += b.weight.x * b.pdf;
                }
                assert!((sum - 1.0).abs() < 1e-14, "{fresnel:?} {lobe:?} {c}: {sum}");
                // Snell: sin θi = eta sin θo
                if b.wi.z < 0.0 {
                    let sine = (b.wi.x * b.wi.x + b.wi.y * b.wi.y).sqrt();
                    assert!((sine - at.eta * (1.0 - c * c).sqrt()).abs() < 1e-14);
                }
            }
        }
    }
}

/// E_r(a, b) = E_r(b, a), and E_t(a → b)/E_t(b → a) = n² without radiance scaling (model.md, "Reciprocity").
#[test]
fn reflection_is_reciprocal_and_transmission_up_to_n2() {
    let mut r = Random::new(6);
    let mut flux = Settings::default();
    flux.model.radiance_scaling = false;
    let (mut reflected, mut transmitted) = (0, 0);
    for i in 0..20_000 {
        let d = DISTRIBUTIONS[i % 3];
        let ior = [1.1, 1.5, 2.5, 1.0 / 1.5][i % 4];
        let m = dielectric(d, parameter(d, 0.1 + 0.9 * r.unit()), ior);
        let mut up = || direction(r.unit(), 6.3 * r.unit());
        let (a, b) = (up(), up());
        // value without the cosine
        let f = |outside: bool, wo: Vec3<f64>, wi: Vec3<f64>| {
            bsdf_eval(&flux, &seen(&m, outside, wo), wi).value.x / wi.z.abs()
        };
        // D at the far end of an exponential magnifies the rounding of the half vector, and values vanish with √r
        // next to the critical angle
        let close = |x: f64, y: f64| {
            let off = (x - y).abs();
            assert!(off <= 1e-8 * x.abs() + 1e-12, "{x} {y}, row {i}");
        };
        for outside in [true, false] {
            close(f(outside, a, b), f(outside, b, a));
            reflected += usize::from(f(outside, a, b) > 0.0);
        }
        // a outside, b inside; the frame of N' is turned over by z → −z
        let over = |v: Vec3<f64>| vec3(v.x, v.y, -v.z);
        let (inwards, outwards) = (f(true, a, over(b)), f(false, b, over(a)));
        close(inwards, outwards * ior * ior);
        transmitted += usize::from(inwards > 0.0);
    }
    assert!(
        reflected > 10_000 && transmitted > 1_000,
        "{reflected} {transmitted}"
    );
}

/// Phong and Beckmann agree about N where α_p = 2/α_b² − 2: D(N) = 1/(π α_b²) (model.md,
/// "Phong and Beckmann at the normal").
#[test]
fn phong_and_beckmann_agree_at_the_normal() {
    for alpha in [0.05, 0.1, 0.3, 0.5, 1.0] {
        let d = |distribution| {
            let m = opaque(
                distribution,
                parameter(distribution, alpha),
                DVec3::ZERO,
                DVec3::ONE,
            );
            let n: Vec3<f64> = vec3(0.0, 0.0, 1.0);
            distribution_d(&seen(&m, true, n).material, n)
        };
        let (phong, beckmann) = (d(Distribution::Phong), d(Distribution::Beckmann));
        assert!(
            (phong / beckmann - 1.0).abs() < 1e-15,
            "{alpha}: {phong} {beckmann}"
        );
    }
}

/// Absorption by `term`: A(t) in transmission and, at total reflection, instead of F; nowhere else (model.md, "Total internal
/// reflection").
#[test]
fn term_absorption_stands_where_transmission_does() {
    let a = vec3(0.5, 0.25, 1.0);
    let settings = Settings::handout();
    let mut r = Random::new(9);
    let (mut total, mut partial, mut through) = (0, 0, 0);
    for i in 0..5_000 {
        let m = dielectric(Distribution::Ggx, [0.0, 0.3][i % 2], 1.5);
        let clear = seen(&m, false, direction(r.unit(), 0.3));
        let mut tinted = clear;
        tinted.attenuation = a;
        let (lobe, reflect, um, ud) = (r.unit(), r.unit(), r.pair(), r.pair());
        let s = bsdf_sample(&settings, &clear, random(lobe, reflect, um, ud));
        let t = bsdf_sample(&settings, &tinted, random(lobe, reflect, um, ud));
        if s.lobe == LOBE_NONE {
            continue;
        }
        let c = (1.0 + dot3(clear.wo, s.wi)).max(0.0) / 2.0;
        let expected = if s.lobe & !LOBE_DELTA == LOBE_TRANSMISSION {
            through += 1;
            a
        } else if total_reflection(&clear, c.sqrt()) {
            total += 1;
            a
        } else {
            partial += 1;
            Vec3::one()
        };
        let off = (t.weight - s.weight * expected).f64().abs().max_element();
        assert!(
            off < 1e-14 * (1.0 + s.weight.x) && t.pdf == s.pdf,
            "{s:?} {t:?}"
        );
    }
    assert!(
        total > 100 && partial > 50 && through > 100,
        "{total} {partial} {through}"
    );
}
