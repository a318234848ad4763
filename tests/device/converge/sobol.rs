//! Samples by Sobol are not independent of one another, but those of two seeds are: the error estimated from replicates
//! and halves is right, where the spread of a pixel's samples is not.

use vkpt::film::{Aov, Film};
use vkpt::metrics::convergence::{Metric, Reference, floor};
use vkpt::metrics::flip::Viewing;
use vkpt::render::{Engine, Job, Replicates, Target};
use vkpt::settings::{Sampler, Settings};

use super::{LIT, RUNNING};
use crate::common::render::{job, outcome, prepared, spread_of_samples};

const SAMPLES: u32 = 16;
const REPLICATES: usize = 24;

fn pictures(job: &Job, seeds: std::ops::Range<u32>, spp: u32) -> Vec<Film> {
    let seeds: Vec<u32> = seeds.collect();
    let mut replicates = Replicates::new(job, &Engine::CpuF32, &seeds).expect("ready");
    let picture = |i: usize| {
        replicates.advance(i, spp, &RUNNING).expect("samples");
        replicates.picture(i)
    };
    (0..seeds.len()).map(picture).collect()
}

/// Mean over pixels and channels of the estimate from two pictures.
fn mean(a: &Film, b: &Film, of: impl Fn(f64, f64) -> f64) -> f64 {
    let values = a.rgb.as_flattened().iter().zip(b.rgb.as_flattened());
    let sum: f64 = values.map(|(&a, &b)| of(a.into(), b.into())).sum();
    sum / (3 * a.rgb.len()) as f64
}

/// Mean of independent values, and its standard error.
fn estimate(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - mean) * (v - mean)).sum();
    (mean, (squares / (n - 1.0) / n).sqrt())
}

#[test]
fn halves_and_replicates_estimate_the_error_and_the_spread_does_not() {
    let mut settings = Settings::default();
    settings.estimator.sampler = Sampler::Sobol;
    let scene = prepared(LIT, &settings);
    let job = job(&scene, settings, SAMPLES, 0);
    let [a, b] = <[Film; 2]>::try_from(pictures(&job, 100..102, 4096)).expect("two");
    let reference = Reference::halves(a, b, &Viewing::default()).expect("two halves");
    let all = pictures(&job, 0..REPLICATES as u32, SAMPLES);

    // The truth: the squared error by far better pictures.
    let figures = |film| {
        reference
            .figures(film, &Viewing::default())
            .expect("a picture")
    };
    let errors: Vec<f64> = all
        .iter()
        .map(|film| figures(film).of(Metric::Mse).all)
        .collect();
    let (truth, doubt_of_mse) = estimate(&errors);
    // For two seeds: E (x − y)²/2, as halves estimate their own error.
    let pairs = all
        .chunks_exact(2)
        .map(|two| mean(&two[0], &two[1], |x, y| 0.5 * (x - y) * (x - y)));
    let (by_pairs, doubt_of_pairs) = estimate(&pairs.collect::<Vec<_>>());
    // 4.44: Student's t of 11 degrees of freedom, two-sided at 1e-3.
    let tolerance = 4.44 * doubt_of_mse.hypot(doubt_of_pairs);
    assert!(
        (by_pairs - truth).abs() < tolerance,
        "{by_pairs} for {truth} ± {tolerance}"
    );
    let floor = floor(&all, &reference).expect("replicates");
    assert!(!floor.is_there(), "{floor:?}");

    // The estimate in a rendering's last line, from two groups of its samples, each with its own scramble.
    let relative = |film| figures(film).of(Metric::RelMse).all;
    let (truth_of_line, doubt) = estimate(&all.iter().map(relative).collect::<Vec<_>>());
    let reported = |seed: u32| {
        let errors = outcome(&Job { seed, ..job }, &Target::CpuF32).state.errors;
        let rel_mse = errors.last().and_then(|e| e.rel_mse);
        rel_mse.expect("two samples").estimate
    };
    let (by_groups, doubt_of_groups) =
        estimate(&(0..REPLICATES as u32).map(reported).collect::<Vec<_>>());
    // 3.77: 23 degrees of freedom.
    let tolerance_of_line = 3.77 * doubt.hypot(doubt_of_groups);
    assert!(
        (by_groups - truth_of_line).abs() < tolerance_of_line,
        "{by_groups} for {truth_of_line} ± {tolerance_of_line}"
    );

    // The estimate of the standard errors of its pixels, from the same two groups.
    let squares = |seed: u32| {
        let with_errors = Job {
            aovs: &[Aov::Stderr],
            seed,
            ..job
        };
        let errors = outcome(&with_errors, &Target::CpuF32)
            .stderr
            .expect("errors");
        mean(&errors, &errors, |e, _| e * e)
    };
    let (by_errors, doubt_of_errors) =
        estimate(&(0..REPLICATES as u32).map(squares).collect::<Vec<_>>());
    let tolerance_of_errors = 3.77 * doubt_of_mse.hypot(doubt_of_errors);
    assert!(
        (by_errors - truth).abs() < tolerance_of_errors,
        "{by_errors} for {truth} ± {tolerance_of_errors}"
    );

    // Planted: the standard errors of samples that are taken for independent.
    let by_samples = spread_of_samples(&job, &[0])[0]
        .as_flattened()
        .iter()
        .sum::<f64>()
        / (3 * all[0].rgb.len()) as f64;
    assert!(
        by_samples > truth + tolerance.max(tolerance_of_errors),
        "{by_samples} for {truth} ± {tolerance}"
    );
}
