//! Path tracing, light tracing and bidirectional path tracing find the same light in each class: the caustic of a glass ball by
//! hitting the lamp behind it, or from the lamp.
//!
//! Means of pictures by several seeds are compared by Welch's t-test; Šidák over all of them at α = 1e-3; fixed seeds.

use vkpt::settings::{Integrator, Sampler};

use super::{settings, split};
use crate::common::render::{job, prepared};
use crate::common::stats::{mean_and_error, p_of_difference, sidak};

const ALPHA: f64 = 1e-3;
const SEEDS: u32 = 24;
const SPP: u32 = 64;

/// A ball of glass over a floor with a sheen, a block of rough metal, a large lamp.
const SCENE: &str = "screen 16 12
camera 0 -6 3 .3 x 65
light 6 5 4
sphere 1 1 4 1
brdf .5 .4 .3 .3 .3 .3 .4
box -4 -4 -.1 8 8 .1
brdf 0 0 0 .04 .04 .04 0 .9 .95 1 1.5
sphere -.6 -.6 .8 .7
brdf .2 .1 .1 .5 .5 .5 .3
box 1 -.5 .002 1 1 1
";

/// Light tracing finds none of the last.
const CLASSES: [&str; 8] = [
    "EDL",
    "EGL",
    "EDS+L",
    "EGS+L",
    "E[DG]DL",
    "E[DG]GL",
    "E[DG]S+[DG].*L",
    "ES.*L",
];
const SEEN_FROM_LIGHTS: usize = 7;

/// The mean of the picture in each class, seed by seed.
fn means(integrator: Integrator) -> Vec<Vec<f64>> {
    let mut settings = settings(integrator, Some(8));
    settings.estimator.sampler = Sampler::Random;
    let scene = prepared(SCENE, &settings);
    let by_seed: Vec<Vec<f64>> = (0..SEEDS)
        .map(|seed| {
            let all = split(&job(&scene, settings, SPP, seed), &CLASSES);
            let mean = |pixels: &Vec<[f32; 3]>| {
                let sum: f64 = pixels.iter().flatten().map(|&x| f64::from(x)).sum();
                sum / (3 * pixels.len()) as f64
            };
            all.iter().map(mean).collect()
        })
        .collect();
    (0..CLASSES.len())
        .map(|i| by_seed.iter().map(|means| means[i]).collect())
        .collect()
}

#[test]
fn integrators_agree_class_by_class() {
    let [path, light, both] = super::INTEGRATORS.map(means);
    let level = sidak(ALPHA, CLASSES.len() + SEEN_FROM_LIGHTS);
    let agree = |a: &[f64], b: &[f64], what: &str| {
        let (of_a, of_b) = (mean_and_error(a), mean_and_error(b));
        let p = p_of_difference(a, b);
        assert!(p > level, "{what}: p = {p}, {of_a:?} and {of_b:?}");
    };
    for (i, pattern) in CLASSES.iter().enumerate() {
        agree(&path[i], &both[i], pattern);
        match i < SEEN_FROM_LIGHTS {
            true => agree(&light[i], &both[i], pattern),
            false => assert!(light[i].iter().all(|&x| x == 0.0), "{pattern}"),
        }
        // There is light, and half as much again is noticed, of the rarest too.
        let (mean, error) = mean_and_error(&both[i]);
        assert!(
            mean > 0.0 && error < 0.05 * mean,
            "{pattern}: {mean} ± {error}"
        );
        let more: Vec<f64> = both[i].iter().map(|x| 1.5 * x).collect();
        assert!(p_of_difference(&more, &both[i]) < level, "{pattern}");
    }
    // One class for another.
    assert!(p_of_difference(&path[0], &both[1]) < level);
    assert!(p_of_difference(&path[2], &both[3]) < level);
}
