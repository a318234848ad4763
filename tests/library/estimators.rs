//! Estimator settings do not move the mean of the picture (model.md, "Estimators agree").
//!
//! Each scene is rendered with the default estimator and with each other setting alone, by several seeds. For every
//! block of the picture and for the whole, the means over the seeds are compared by Welch's t-test; Šidák over all
//! blocks, settings and scenes at α = 1e-3; fixed seeds. By the reference in f32, which the device equals bit for bit
//! with each of these settings (`tests/device/same_bits.rs`).
//!
//! That `--connect light` and `bsdf` find all light in any scene: whether a path's last vertex before a light
//! scatters by a delta lobe or not is a property of that path. With `light`, hits count in full after delta lobes and
//! the camera, and connections replace all others: the light samplers reach every point of a light. With `bsdf`,
//! hits alone count, and every lobe is drawn wherever its value is not 0.

use vkpt::prepared::Prepared;
use vkpt::render::Target;
use vkpt::settings::Settings;

use crate::common::render::{job, outcome, pixel_means, prepared};
use crate::common::scenes::{FLUSH, MANY, SMOOTH, TABLE, WIDE};
use crate::common::settings::estimators;
use crate::common::stats::{mean_and_error, p_of_difference, sidak};

const ALPHA: f64 = 1e-3;
/// Blocks of 8 × 8 pixels in 32 × 24, and the whole picture.
pub const MEANS: usize = 4 * 3 + 1;
const SCENES: [(&str, &str); 5] = [
    ("table", TABLE),
    ("smooth", SMOOTH),
    ("wide", WIDE),
    ("flush", FLUSH),
    ("many", MANY),
];

/// How much is rendered of each picture.
#[derive(Clone, Copy)]
pub struct Effort {
    pub seeds: u32,
    pub spp: u32,
}

impl Effort {
    /// Of the slow tests: means of whole pictures are known to some thousandths (`relative_error`), in less than an hour.
    pub const LONG: Effort = Effort {
        seeds: 24,
        spp: 512,
    };
}

/// The standard error of the mean of the whole picture, by that mean.
pub fn relative_error(means: &[Vec<f64>]) -> f64 {
    let (mean, error) = mean_and_error(&means[MEANS - 1]);
    error / mean
}

/// For each block and for the whole picture its mean, seed by seed.
pub fn means(
    scene: &Prepared,
    settings: Settings,
    effort: Effort,
    first_seed: u32,
) -> Vec<Vec<f64>> {
    let mut means = vec![Vec::new(); MEANS];
    for k in 0..effort.seeds {
        let job = job(scene, settings, effort.spp, first_seed + k);
        let outcome = outcome(&job, &Target::CpuF32);
        assert_eq!(
            outcome.stats.dropped,
            Default::default(),
            "seed {}, {:?}",
            job.seed,
            settings.estimator
        );
        for (all, mean) in means
            .iter_mut()
            .zip(block_means(&pixel_means(&outcome.film)))
        {
            all.push(mean);
        }
    }
    means
}

/// The mean of each block of 8 × 8 pixels, and of the whole.
pub fn block_means(pixels: &[f64]) -> Vec<f64> {
    let mut sums = [0.0; MEANS];
    for (i, x) in pixels.iter().enumerate() {
        let (column, row) = (i % 32, i / 32);
        sums[row / 8 * 4 + column / 8] += x / 64.0;
        sums[MEANS - 1] += x / 768.0;
    }
    sums.to_vec()
}

/// Compares every estimator with the default one.
fn check(effort: Effort) {
    let settings = estimators();
    let level = sidak(ALPHA, SCENES.len() * settings.len() * MEANS);
    let (mut least, mut error) = (1.0, 0.0);
    for (s, (scene, text)) in SCENES.into_iter().enumerate() {
        let render = |settings: Settings, k: usize| {
            let prepared = prepared(text, &settings);
            means(&prepared, settings, effort, seed(s, k))
        };
        let default = render(Settings::default(), 0);
        for (k, (name, settings)) in settings.iter().enumerate() {
            let other = render(*settings, k + 1);
            error = f64::max(error, relative_error(&other));
            for (block, (a, b)) in default.iter().zip(&other).enumerate() {
                let p = p_of_difference(a, b);
                assert!(p > level, "{scene}, {name}, block {block}: p = {p:e}");
                least = f64::min(least, p);
            }
        }
    }
    println!("least p-value {least:.1e}, level {level:.1e}, largest standard error {error:.1e}");
}

/// Seeds that no two settings share: picture `k` of scene `s` has its own thousand.
fn seed(s: usize, k: usize) -> u32 {
    (1000 * (20 * s + k)) as u32
}

#[test]
fn they_do_not_move_the_mean() {
    check(Effort { seeds: 24, spp: 64 });
}

#[test]
#[ignore = "up to an hour"]
fn they_do_not_move_the_mean_by_a_thousandth() {
    check(Effort::LONG);
}

/// The means of whole pictures detect 1 % more light and 1 % more Kd, at the level of the family above.
#[test]
fn an_error_of_one_per_cent_is_noticed() {
    let effort = Effort { seeds: 24, spp: 64 };
    let level = sidak(ALPHA, SCENES.len() * estimators().len() * MEANS);
    let planted = [
        (TABLE, "light 6 5 4", "light 6.06 5.05 4.04"),
        (TABLE, "brdf .6 .5 .4", "brdf .606 .505 .404"),
        (SMOOTH, "background .4 .5 .6", "background .404 .505 .606"),
    ];
    for (k, (text, right, wrong)) in planted.into_iter().enumerate() {
        assert!(text.contains(right));
        let whole = |text: &str, k: usize| {
            let settings = Settings::default();
            let prepared = prepared(text, &settings);
            means(&prepared, settings, effort, seed(10, k)).remove(MEANS - 1)
        };
        let p = p_of_difference(
            &whole(text, 2 * k),
            &whole(&text.replace(right, wrong), 2 * k + 1),
        );
        println!("{wrong}: p = {p:.1e}");
        assert!(p < level, "{wrong} for {right}: p = {p:e}");
    }
}
