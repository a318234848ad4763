//! `--aov stderr` is honest: over many seeds the mean of its square is the variance that a pixel has, by path and light
//! tracing, of independent samples and of Sobol's points; the estimate from the spread of Sobol's points is not.

use vkpt::film::{Aov, Film};
use vkpt::prepared::Prepared;
use vkpt::render::{Job, Target};
use vkpt::settings::{Integrator, Sampler, Settings};

use crate::common::render::{job, outcome, prepared, spread_of_samples};
use crate::common::stats::{p_of_mean, sidak};

/// A ball of light over a floor, in few pixels: integrands that Sobol's points are good at, of light paths too.
const SCENE: &str = "screen 2 2
camera 0 -6 4 .7 x 50
light 6 5 4
sphere 0 0 2 .5
brdf .6 .5 .4 0 0 0 1
box -50 -50 -.1 100 100 .1
";

const SPP: u32 = 16;
const SEEDS: u32 = 2000;

/// All tests of this file together.
const ALPHA: f64 = 1e-3;
const TESTS: usize = 8;

type Values = Vec<[f64; 3]>;

fn settings(sampler: Sampler, integrator: Integrator) -> Settings {
    let mut settings = Settings::default();
    settings.estimator.sampler = sampler;
    settings.estimator.integrator = integrator;
    settings
}

fn with_errors(scene: &Prepared, settings: Settings, seed: u32) -> Job<'_> {
    Job {
        aovs: &[Aov::Stderr],
        ..job(scene, settings, SPP, seed)
    }
}

/// A picture of each seed, and the squares of its standard errors.
fn reported(scene: &Prepared, settings: Settings) -> (Vec<Film>, Vec<Values>) {
    let of = |seed| {
        let outcome = outcome(&with_errors(scene, settings, seed), &Target::CpuF32);
        let square = |p: &[f32; 3]| p.map(|e| f64::from(e) * f64::from(e));
        let squares = outcome
            .stderr
            .expect("two samples or more")
            .rgb
            .iter()
            .map(square)
            .collect();
        (outcome.film, squares)
    };
    (0..SEEDS).map(of).unzip()
}

/// Whether the mean of `squares` is the variance of the pictures' values, as a p-value (Student's t).
///
/// For two pictures x and y by independent seeds, (x − y)²/2 estimates the variance of each value without bias. Minus the mean
/// of the estimates of both, it is 0 on average; the mean over pixels and channels of that is a number a pair.
fn p_of_honesty(pictures: &[Film], squares: &[Values]) -> f64 {
    let excess = |(films, squares): (&[Film], &[Values])| {
        let values = films[0]
            .rgb
            .as_flattened()
            .iter()
            .zip(films[1].rgb.as_flattened());
        let variance: f64 = values.map(|(x, y)| 0.5 * f64::from(x - y).powi(2)).sum();
        let mean_square: f64 = squares.iter().flat_map(|s| s.as_flattened()).sum::<f64>() / 2.0;
        (variance - mean_square) / (3 * films[0].rgb.len()) as f64
    };
    let pairs = pictures.chunks_exact(2).zip(squares.chunks_exact(2));
    let all: Vec<f64> = pairs.map(excess).collect();
    p_of_mean(&all, 0.0, 0.0)
}

/// The mean square of all errors, printed for people.
fn mean(squares: &[Values]) -> f64 {
    let all: Vec<f64> = squares
        .iter()
        .flat_map(|s| s.as_flattened())
        .copied()
        .collect();
    all.iter().sum::<f64>() / all.len() as f64
}

#[test]
fn the_mean_square_is_the_variance_of_the_pixel() {
    let level = sidak(ALPHA, TESTS);
    for integrator in [Integrator::Path, Integrator::Light] {
        for sampler in [Sampler::Random, Sampler::Sobol] {
            let settings = settings(sampler, integrator);
            let scene = prepared(SCENE, &settings);
            let (pictures, squares) = reported(&scene, settings);
            let p = p_of_honesty(&pictures, &squares);
            // Planted: errors a tenth too large; of Sobol's points those of their spread.
            let planted = match sampler {
                Sampler::Random => scaled(&squares, 1.1),
                _ => {
                    let seeds: Vec<u32> = (0..SEEDS).collect();
                    spread_of_samples(&with_errors(&scene, settings, 0), &seeds)
                }
            };
            let p_of_planted = p_of_honesty(&pictures, &planted);
            println!(
                "{integrator:?}, {sampler:?}: p = {p:.2}; planted, {:.2} of the mean square, p = {p_of_planted:.1e}",
                mean(&planted) / mean(&squares)
            );
            assert!(p > level, "{integrator:?}, {sampler:?}: {p:e}");
            assert!(
                p_of_planted < level,
                "{integrator:?}, {sampler:?}: {p_of_planted:e}"
            );
        }
    }
}

/// Errors, not their squares, times `factor`.
fn scaled(squares: &[Values], factor: f64) -> Vec<Values> {
    let of = |s: &Values| s.iter().map(|p| p.map(|x| factor * factor * x)).collect();
    squares.iter().map(of).collect()
}
