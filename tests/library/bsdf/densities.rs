//! Samples follow the density that they claim, and ∫density + P(invalid) = 1 (model.md, "Samples against density").

use glam::DVec3;
use vkpt::prepared;
use vkpt::reference::bsdf::{Interaction, LOBE_NONE, bsdf_eval, bsdf_sample};
use vkpt::settings::{Distribution, Fresnel, Settings};

use super::support::chi_square::{Verdict, compare, expectation, histogram};
use super::support::random::{Random, random};
use super::support::statistics::sidak;
use super::support::surface::{
    DISTRIBUTIONS, ESTIMATORS, dielectric, direction, estimator, opaque, parameter, seen,
};

const WIDTHS: [f64; 4] = [0.05, 0.1, 0.3, 1.0];
const IORS: [f64; 4] = [1.1, 1.5, 2.5, 1.0 / 1.5];
const COSINES: [f64; 3] = [0.95, 0.6, 0.15];
/// Of a whole family: a truth is rejected once in a hundred suites with other seeds.
const LEVEL: f64 = 0.01;

struct Case {
    name: String,
    settings: Settings,
    at: Interaction<f64>,
    width: f64,
}

/// Every distribution, width, ior (or opaque), side, Fresnel term, angle and estimator.
fn cases() -> Vec<Case> {
    let mut all = Vec::new();
    for distribution in DISTRIBUTIONS {
        for width in WIDTHS {
            for (m, outside) in materials(distribution, width) {
                for cosine in COSINES {
                    for (lobe, normals) in ESTIMATORS {
                        let azimuth = 0.4 + all.len() as f64;
                        all.push(Case {
                            name: format!(
                                "{distribution:?} {width}, {:?}, eta {:.3}, Kd {:.1}, cos {cosine}, {lobe:?}, {normals:?}",
                                m.fresnel, m.eta[usize::from(!outside)], m.kd_mean
                            ),
                            settings: estimator(lobe, normals),
                            at: seen(&m, outside, direction(cosine, azimuth)),
                            width,
                        });
                    }
                }
            }
        }
    }
    all
}

/// An opaque one, and each ior from both sides with either Fresnel term; every other one has a diffuse lobe too.
fn materials(distribution: Distribution, width: f64) -> Vec<(prepared::Material, bool)> {
    let alpha = parameter(distribution, width);
    let plastic = opaque(distribution, alpha, DVec3::splat(0.4), DVec3::splat(0.3));
    let mut all = vec![(plastic, true)];
    for (i, ior) in IORS.into_iter().enumerate() {
        let sides = [true, false].into_iter();
        let terms = [Fresnel::Exact, Fresnel::Schlick];
        for (outside, fresnel) in sides.flat_map(|side| terms.map(|f| (side, f))) {
            let mut m = dielectric(distribution, alpha, ior);
            m.fresnel = fresnel;
            // its own reflectance in each channel: the choice goes by their mean
            m.f0 = DVec3::new(0.02, 0.1, 0.3);
            // enough of either lobe, by norms
            m.p_r = 0.4;
            if i % 2 == 1 {
                m.kd = DVec3::splat(0.5);
                m.kd_mean = 0.5;
                m.p_d = 0.3;
            }
            all.push((m, outside));
        }
    }
    all
}

fn verdict(case: &Case, samples: u64, seed: u64) -> Verdict {
    let mut r = Random::new(seed);
    let found = histogram(samples, || {
        let (lobe, reflect, m, d) = (r.unit(), r.unit(), r.pair(), r.pair());
        let s = bsdf_sample(&case.settings, &case.at, random(lobe, reflect, m, d));
        (s.lobe != LOBE_NONE).then_some(s.wi)
    });
    let density = |wi| bsdf_eval(&case.settings, &case.at, wi).pdf;
    compare(&found, &expectation(cuts(case.width), density))
}

/// Narrow lobes need more cells to be seen: 40 × 40 nodes a bin, 16 × 16 for wide ones.
fn cuts(width: f64) -> usize {
    if width < 0.2 { 5 } else { 2 }
}

/// Every `stride`-th case, on all cores; a failure lists all that were rejected.
fn all_fit(stride: usize, samples: u64) {
    let chosen: Vec<_> = cases().into_iter().enumerate().step_by(stride).collect();
    let least = sidak(LEVEL, 2 * chosen.len());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let rejected = |part: &[(usize, Case)]| -> Vec<String> {
        part.iter()
            .map(|(i, case)| (case, verdict(case, samples, *i as u64)))
            .filter(|(_, v)| v.p() < least)
            .map(|(case, v)| format!("{}: {v:?}", case.name))
            .collect()
    };
    let bad: Vec<String> = std::thread::scope(|scope| {
        let parts = chosen.chunks(chosen.len().div_ceil(cores));
        let threads: Vec<_> = parts.map(|p| scope.spawn(move || rejected(p))).collect();
        threads
            .into_iter()
            .flat_map(|t| t.join().expect("a part"))
            .collect()
    });
    assert!(
        bad.is_empty(),
        "{} of {} at significance {least:e}:\n{}",
        bad.len(),
        chosen.len(),
        bad.join("\n")
    );
}

#[test]
fn samples_fit_their_density() {
    // 79 has no factor in common with the number of values of anything that is varied: all values come up
    all_fit(79, 200_000);
}

#[test]
#[ignore = "minutes: every combination, a million samples each"]
fn samples_fit_their_density_everywhere() {
    all_fit(1, 1_000_000);
}
