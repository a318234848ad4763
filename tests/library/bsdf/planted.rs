//! Errors that the comparison of samples with densities must notice (model.md, "Samples against density").

use glam::DVec3;
use vkpt::reference::bsdf::{Interaction, LOBE_NONE, bsdf_eval, bsdf_sample};
use vkpt::reference::math::{Vec3, dot3};
use vkpt::settings::{Distribution, LobeChoice, Normals, Settings};

use super::support::chi_square::{Verdict, compare, expectation, histogram};
use super::support::random::{Random, random};
use super::support::surface::{dielectric, direction, estimator, opaque, seen};

/// The verdict on `density` for a rough glass with ior 1/1.5, or on `sample`.
struct Planted {
    settings: Settings,
    at: Interaction<f64>,
}

impl Planted {
    fn new() -> Self {
        let m = dielectric(Distribution::Ggx, 0.3, 1.0 / 1.5);
        Self {
            settings: estimator(LobeChoice::Fresnel, Normals::Visible),
            at: seen(&m, true, direction(0.6, 0.4)),
        }
    }
    fn verdict(&self, density: impl Fn(Vec3<f64>) -> f64) -> Verdict {
        let mut r = Random::new(5);
        let found = histogram(200_000, || {
            let s = bsdf_sample(
                &self.settings,
                &self.at,
                random(r.unit(), r.unit(), r.pair(), r.pair()),
            );
            (s.lobe != LOBE_NONE).then_some(s.wi)
        });
        compare(&found, &expectation(2, density))
    }
    fn pdf(&self, wi: Vec3<f64>) -> f64 {
        bsdf_eval(&self.settings, &self.at, wi).pdf
    }
}

const REJECTED: f64 = 1e-9;

#[test]
fn a_density_one_percent_off_is_rejected() {
    let p = Planted::new();
    assert!(p.verdict(|wi| p.pdf(wi)).p() > 1e-3);
    assert!(p.verdict(|wi| 1.01 * p.pdf(wi)).p() < REJECTED);
    assert!(p.verdict(|wi| 0.99 * p.pdf(wi)).p() < REJECTED);
}

#[test]
fn swapped_lobes_are_rejected() {
    let p = Planted::new();
    let mut other = p.settings;
    other.estimator.lobe = LobeChoice::Norms;
    assert!(p.verdict(|wi| bsdf_eval(&other, &p.at, wi).pdf).fit < REJECTED);
    other.estimator.lobe = LobeChoice::Fresnel;
    other.estimator.normals = Normals::Distribution;
    assert!(p.verdict(|wi| bsdf_eval(&other, &p.at, wi).pdf).fit < REJECTED);
}

#[test]
fn the_handouts_half_vector_is_rejected() {
    // m = −normalize(eta wo + wi) for any ior: below N' for ior < 1, where D = 0
    let p = Planted::new();
    let handout = |wi: Vec3<f64>| if wi.z < 0.0 { 0.0 } else { p.pdf(wi) };
    assert!(p.verdict(handout).p() < REJECTED);
    // and its η by the prose: the two sides exchanged
    let mut prose = Planted::new();
    (prose.at.eta, prose.at.one_minus_eta2, prose.at.d) = {
        let m = prose.at.material;
        (m.eta[1], m.one_minus_eta2[1], m.d[1])
    };
    assert!(p.verdict(|wi| prose.pdf(wi)).p() < REJECTED);
}

#[test]
fn the_handouts_phong_is_rejected() {
    // cos θ = u^(1/(α_p + 1)) against D(m)·(m·N), whose exponent is α_p + 2
    let m = opaque(Distribution::Phong, 10.0, DVec3::ZERO, DVec3::ONE);
    let settings = estimator(LobeChoice::Fresnel, Normals::Distribution);
    let at = seen(&m, true, direction(0.9, 0.4));
    let expected = expectation(2, |wi| bsdf_eval(&settings, &at, wi).pdf);
    let fit = |exponent: f64| {
        let mut r = Random::new(6);
        let found = histogram(200_000, || {
            let z = (1.0 - r.unit()).powf(1.0 / exponent);
            let m = direction(z, std::f64::consts::TAU * r.unit());
            let c = dot3(at.wo, m);
            let wi = m * (2.0 * c) - at.wo;
            (c > 0.0 && wi.z > 0.0).then_some(wi)
        });
        compare(&found, &expected).p()
    };
    assert!(fit(12.0) > 1e-3);
    assert!(fit(11.0) < REJECTED);
}
