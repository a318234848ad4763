//! The error that a rendering estimates of itself, against its actual error: the project's scenes, by random numbers
//! and by Sobol's points, with pictures of a hundred times the samples as the truth.

use std::path::Path;

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::film::Film;
use vkpt::metrics::convergence::Reference;
use vkpt::metrics::flip::Viewing;
use vkpt::metrics::noise::RelMse;
use vkpt::prepared::Prepared;
use vkpt::render::{Job, Outcome, Target};
use vkpt::settings::{Integrator, Sampler, Settings};

use crate::common::render::{job, on_device, outcome, prepared_file};
use crate::common::settings::by;
use crate::common::stats::sidak;

const SIZE: [u32; 2] = [48, 36];

/// Samples per pixel of a picture, and of each half of its reference: the halves' own noise has no part in the error
/// on average, and spreads it by 2 √(spp/REFERENCE_SPP/pixels), a two-hundredth.
const SPP: u32 = 32;
const REFERENCE_SPP: u32 = 64 * SPP;

/// A rendering by the device where there is one (on a CPU driver the reference's picture to the bit), else by f32; bidirectional
/// paths by f32, which a CPU driver is slower than.
fn rendered(job: &Job) -> Outcome {
    let device = match job.settings.estimator.integrator {
        Integrator::Bidirectional => None,
        _ => on_device(job),
    };
    device.unwrap_or_else(|| outcome(job, &Target::CpuF32))
}

/// The error of one picture, and its own estimate of it.
struct Reported {
    truth: f64,
    estimate: RelMse,
}

fn reference(scene: &Prepared, integrator: Integrator) -> Reference {
    let settings = drawn(integrator, Sampler::Sobol);
    let half = |seed| rendered(&job(scene, settings, REFERENCE_SPP, seed)).film;
    let [a, b]: [Film; 2] = [1_000_001, 1_000_002].map(half);
    Reference::halves(a, b, &Viewing::default()).expect("two halves")
}

fn drawn(integrator: Integrator, sampler: Sampler) -> Settings {
    let mut settings = by(integrator);
    settings.estimator.sampler = sampler;
    settings
}

fn reported(scene: &Prepared, settings: Settings, pictures: u32) -> Vec<Reported> {
    let reference = reference(scene, settings.estimator.integrator);
    let of = |seed| {
        let outcome = rendered(&job(scene, settings, SPP, seed));
        let figures = reference.figures(&outcome.film, &Viewing::default());
        let last = outcome.state.errors.last().and_then(|e| e.rel_mse);
        Reported {
            truth: figures.expect("figures").rel_mse.all,
            estimate: last.expect("an estimate"),
        }
    };
    (5000..5000 + pictures).map(of).collect()
}

/// The number of intervals, and how many of them miss a truth that is scaled by `scale`.
fn misses(all: &[Reported], scale: f64) -> [u64; 2] {
    let intervals = all
        .iter()
        .filter_map(|t| Some((scale * t.truth, t.estimate.interval.ok()?)));
    let missed = intervals
        .clone()
        .filter(|(truth, [low, high])| truth < low || truth > high);
    [intervals.count() as u64, missed.count() as u64]
}

/// P(K ≥ k) of K misses in n at 5 % each.
fn p_of([n, k]: [u64; 2]) -> f64 {
    let binomial = Binomial::new(0.05, n).expect("a probability");
    if k == 0 { 1.0 } else { binomial.sf(k - 1) }
}

/// Checks the coverage of all scenes' intervals, at 1e-3 for all of them together; where there are intervals, a truth planted
/// 1.5 times as large or as small must be noticed.
fn check(scenes: &[&str], integrator: Integrator, pictures: u32) {
    let level = sidak(1e-3, 2 * scenes.len());
    for name in scenes {
        let path = format!("{}/scenes/{name}.txt", env!("CARGO_MANIFEST_DIR"));
        let settings = Settings::default();
        let scene = prepared_file(Path::new(&path), &settings, Some(SIZE));
        for sampler in [Sampler::Random, Sampler::Sobol] {
            let all = reported(&scene, drawn(integrator, sampler), pictures);
            let count = misses(&all, 1.0);
            let [given, missed] = count;
            let mean =
                |of: fn(&Reported) -> f64| all.iter().map(of).sum::<f64>() / all.len() as f64;
            let ratio = mean(|t| t.estimate.estimate) / mean(|t| t.truth);
            println!(
                "{name}, {sampler:?}: {missed} of {given} intervals miss, {} give none; estimate/truth {ratio:.3}",
                all.len() as u64 - given
            );
            assert!(p_of(count) > level, "{name}, {sampler:?}: {count:?}");
            for planted in [1.5, 1.0 / 1.5] {
                let count = misses(&all, planted);
                assert!(
                    given < u64::from(pictures) / 2 || p_of(count) < level,
                    "{name}, {sampler:?}, × {planted}: {count:?}"
                );
            }
        }
    }
}

#[test]
fn intervals_contain_the_error_of_a_furnace() {
    check(&["furnace"], Integrator::Path, 60);
}

#[test]
#[ignore = "ten minutes"]
fn intervals_contain_the_error_of_all_scenes() {
    check(
        &[
            "furnace",
            "diffuse",
            "slab",
            "absorption",
            "room",
            "many-lights",
            "veach-plates",
            "glass-table",
            "roughness-ggx",
            "caustic",
        ],
        Integrator::Path,
        400,
    );
}

/// Splats of one light path fall on many pixels, whose errors are then not independent.
#[test]
#[ignore = "ten minutes"]
fn intervals_contain_the_error_of_bidirectional_paths() {
    check(
        &["room", "caustic", "frosted-globe", "glass-table"],
        Integrator::Bidirectional,
        200,
    );
}
