//! Micro-normals alone (model.md, "Samples against density"): every distribution at every width, drawn from D(m)·(m·N)
//! or as `wo` sees them.
//!
//! The bins of `densities` are as wide as the narrowest lobes. These here are as narrow as the distribution:
//! x = 1 − 1/√(1 + r²), r = tan θ/α, and φ stretch the lobe of a GGX of width α over the square.

use std::f64::consts::TAU;

use glam::DVec3;
use vkpt::reference::bsdf::Interaction;
use vkpt::reference::bsdf::normals::{normals_pdf, normals_sample};
use vkpt::reference::math::Vec3;
use vkpt::settings::{Distribution, LobeChoice, Normals, Settings};

use super::support::chi_square::{Verdict, compare, expectation_by, histogram_by};
use super::support::random::Random;
use super::support::statistics::sidak;
use super::support::surface::{DISTRIBUTIONS, direction, estimator, opaque, parameter, seen};

const WIDTHS: [f64; 6] = [1e-3, 0.01, 0.05, 0.1, 0.3, 1.0];
const COSINES: [f64; 3] = [0.95, 0.6, 0.1];
const SAMPLES: u64 = 50_000;
/// Of the whole family.
const LEVEL: f64 = 0.01;

struct Case {
    settings: Settings,
    at: Interaction<f64>,
    width: f64,
}

fn case(distribution: Distribution, width: f64, normals: Normals, cosine: f64) -> Case {
    let alpha = parameter(distribution, width);
    let m = opaque(distribution, alpha, DVec3::ZERO, DVec3::ONE);
    Case {
        settings: estimator(LobeChoice::Fresnel, normals),
        at: seen(&m, true, direction(cosine, 0.7)),
        width,
    }
}

/// (x, φ/2π) of a micro-normal.
fn place(width: f64, m: Vec3<f64>) -> [f64; 2] {
    let r2 = (m.x * m.x + m.y * m.y) / (m.z * m.z) / (width * width);
    [
        1.0 - 1.0 / (1.0 + r2).sqrt(),
        (m.y.atan2(m.x) / TAU).rem_euclid(1.0),
    ]
}

/// The micro-normal at (x, φ/2π), and dω/(dx d(φ/2π)) = 2π α² cos³ θ/y³ with y = 1 − x: α² tan⁻² θ = y²/(1 − y²),
/// cos θ = (1 + tan² θ)^−½.
fn micro_normal(width: f64, [x, turn]: [f64; 2]) -> (Vec3<f64>, f64) {
    let y = 1.0 - x;
    let tan2 = width * width * (1.0 - y * y) / (y * y);
    let cos = 1.0 / (1.0 + tan2).sqrt();
    let solid_angle = TAU * width * width * (cos / y).powi(3);
    (direction(cos, TAU * turn), solid_angle)
}

fn verdict(case: &Case, seed: u64, density: impl Fn(Vec3<f64>) -> f64) -> Verdict {
    let mut r = Random::new(seed);
    let found = histogram_by(SAMPLES, || {
        let m = normals_sample(&case.settings, &case.at, r.pair());
        Some(place(case.width, m))
    });
    let expected = expectation_by(2, |at| {
        let (m, solid_angle) = micro_normal(case.width, at);
        density(m) * solid_angle
    });
    compare(&found, &expected)
}

#[test]
fn micro_normals_follow_their_density() {
    let mut found = Vec::new();
    for distribution in DISTRIBUTIONS {
        for (width, cosine) in WIDTHS.iter().flat_map(|w| COSINES.map(|c| (*w, c))) {
            for normals in [Normals::Visible, Normals::Distribution] {
                let c = case(distribution, width, normals, cosine);
                let pdf = |m| normals_pdf(&c.settings, &c.at, m);
                let name = format!("{distribution:?} {width}, {normals:?}, cos {cosine}");
                found.push((name, verdict(&c, found.len() as u64, pdf)));
            }
        }
    }
    let least = sidak(LEVEL, 2 * found.len());
    let bad: Vec<_> = found.iter().filter(|(_, v)| v.p() < least).collect();
    assert!(bad.is_empty(), "at significance {least:e}: {bad:#?}");
}

/// Another distribution of the same width, a width 10 % off, a density 1 % off, no masking, the azimuth of `wo` mirrored: all
/// at the narrowest width, where coarse bins would not distinguish them.
#[test]
fn planted_errors_are_rejected() {
    let c = case(Distribution::Ggx, 1e-3, Normals::Visible, 0.6);
    let other = case(Distribution::Beckmann, 1e-3, Normals::Distribution, 0.6);
    let wider = case(Distribution::Ggx, 1.1e-3, Normals::Visible, 0.6);
    let pdf = |c: &Case, m| normals_pdf(&c.settings, &c.at, m);
    assert!(verdict(&c, 1, |m| pdf(&c, m)).p() > 1e-3);
    let mut plain = case(Distribution::Ggx, 0.3, Normals::Visible, 0.1);
    plain.settings.estimator.normals = Normals::Distribution;
    let seen_ones = case(Distribution::Ggx, 0.3, Normals::Visible, 0.1);
    let mut turned = case(Distribution::Ggx, 0.3, Normals::Visible, 0.1);
    turned.at.wo.x = -turned.at.wo.x;
    let planted = [
        verdict(&c, 1, |m| pdf(&other, m)),
        verdict(&c, 1, |m| pdf(&wider, m)),
        verdict(&c, 1, |m| 1.01 * pdf(&c, m)),
        verdict(&seen_ones, 1, |m| pdf(&plain, m)),
        verdict(&seen_ones, 1, |m| pdf(&turned, m)),
    ];
    for (i, v) in planted.iter().enumerate() {
        assert!(v.p() < 1e-6, "planted error {i}: {v:?}");
    }
}
