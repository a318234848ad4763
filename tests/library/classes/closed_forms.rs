//! Classes by closed forms: a lamp over a floor, and behind a pane.

use vkpt::settings::{Integrator, Sampler};

use super::{INTEGRATORS, settings, split};
use crate::common::render::{job, prepared};
use crate::common::stats::{mean_and_error, p_of_mean, sidak};

const ALPHA: f64 = 1e-3;
/// Of f32 paths, relative.
const ROUNDING: f64 = 1e-5;

/// Red of a class, pixel by pixel.
fn red(pixels: &[[f32; 3]]) -> Vec<f64> {
    pixels.iter().map(|rgb| rgb[0].into()).collect()
}

/// One point of a floor, seen from straight above, below a ball of light that is not in the picture.
///
/// A ball of radius r whose centre is d away, at the angle θ from the normal, and which is above the horizon: irradiance
/// π L (r/d)² cos θ, radiance Kd L (r/d)² cos θ by one bounce.
#[test]
fn the_diffuse_part_of_a_floor_is_known_beside_any_other_lobe() {
    let scene = |brdf| {
        format!(
            "screen 32 24\ncamera 0 0 6 1e-5\nlight 8 8 8\nsphere 2 0 4 .5\nbrdf {brdf}\nbox -50 -50 -1 100 100 1\n"
        )
    };
    let square = 2f64.powi(2) + 4f64.powi(2);
    let of_kd = 0.5 * 8.0 * 0.5f64.powi(2) / square * (4.0 / square.sqrt());
    // Connections alone, and those of paths from both ends. A light path hardly ever comes to that point.
    for integrator in [Integrator::Path, Integrator::Bidirectional] {
        let mut settings = settings(integrator, Some(1));
        settings.estimator.sampler = Sampler::Random;
        let of = |brdf| {
            let scene = prepared(&scene(brdf), &settings);
            let job = job(&scene, settings, 64, 1);
            split(&job, &["EDL", "EGL", "EL", "ES.*L", "E...*L"])
        };
        let (plain, sheen) = (of(".5 .5 .5 0 0 0 1"), of(".5 .5 .5 .4 .4 .4 .5"));
        for all in [&plain, &sheen] {
            let diffuse = red(&all[0]);
            let (mean, error) = mean_and_error(&diffuse);
            let p = p_of_mean(&diffuse, of_kd, ROUNDING * of_kd);
            assert!(
                p > sidak(ALPHA, 4),
                "{integrator:?}: {mean} ± {error}, expected {of_kd}"
            );
            // Another 2 % are noticed.
            assert!(p_of_mean(&diffuse, 1.02 * of_kd, 0.0) < ALPHA);
            assert!(all[2..].iter().flatten().flatten().all(|&x| x == 0.0));
        }
        // The rest is the sheen's, and as large as without Kd.
        assert!(red(&plain[1]).iter().all(|&x| x == 0.0));
        let alone = red(&of("0 0 0 .4 .4 .4 .5")[1]);
        let (expected, error) = mean_and_error(&alone);
        let (mean, own) = mean_and_error(&red(&sheen[1]));
        let z = (mean - expected) / error.hypot(own);
        assert!(
            z.abs() < 3.9,
            "{integrator:?}: {mean} ± {own}, {expected} ± {error}"
        );
        assert!(mean > 0.02 * of_kd);
    }
}

/// A lamp that is seen has its own radiance: EL, and nothing else, in the scene's f32.
#[test]
fn a_lamp_that_is_seen_is_no_surface() {
    let scene = "screen 8 6\ncamera 0 0 9 .1\nlight 6 3 .3\nbox -9 -9 -1 18 18 1\n";
    for integrator in [Integrator::Path, Integrator::Bidirectional] {
        let settings = settings(integrator, None);
        let scene = prepared(scene, &settings);
        let all = split(&job(&scene, settings, 16, 1), &["EL", "E.+L"]);
        assert!(all[0].iter().all(|rgb| *rgb == [6.0, 3.0, 0.3]));
        assert!(all[1].iter().all(|rgb| *rgb == [0.0; 3]));
    }
}

/// A pane before a lamp, straight on, F = .04 at either face: (1 − F)² goes straight through, (1 − F)² F² after two
/// reflections within, (1 − F)/(1 + F) in all.
#[test]
fn a_lamp_behind_a_pane_is_smooth_twice_and_more() {
    let scene = "screen 64 48\ncamera 0 0 9 1e-5\nlight 6 3 1\nbox -50 -50 -1 100 100 1\n\
                 brdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\nbox -50 -50 3 100 100 1\n";
    let f: f64 = 0.04;
    let through = (1.0 - f).powi(2);
    let expected = [through, through * f * f, (1.0 - f) / (1.0 + f)].map(|share| 6.0 * share);
    for integrator in [Integrator::Path, Integrator::Bidirectional] {
        let mut settings = settings(integrator, None);
        settings.estimator.sampler = Sampler::Random;
        let scene = prepared(scene, &settings);
        let bright = [
            "ESSL",
            "ESSSSL",
            "E(SS)+L",
            "ETTL",
            "E<TS>RR<TS>L",
            "ET(RR)*TL",
        ];
        let dark = ["EL", "E.*[DG].*L", "E(..)*.L", "ER.*L", "E.*T.*T.*T.*L"];
        let of = |patterns| split(&job(&scene, settings, 64, 1), patterns);
        let expected = expected.iter().cycle();
        for ((pixels, expected), pattern) in of(&bright).iter().zip(expected).zip(bright) {
            let found = red(pixels);
            let p = p_of_mean(&found, *expected, ROUNDING * expected);
            let (mean, error) = mean_and_error(&found);
            assert!(
                p > sidak(ALPHA, 12),
                "{integrator:?}, {pattern}: {mean} ± {error}, expected {expected}"
            );
            assert!(p_of_mean(&found, 1.2 * expected, 0.0) < ALPHA, "{pattern}");
        }
        assert!(of(&dark).iter().flatten().flatten().all(|&x| x == 0.0));
    }
}

/// Rough glass fills all below the picture's only surface: light from a lamp in it was transmitted, from one above reflected.
#[test]
fn rough_glass_reflects_the_lamp_above_it_and_transmits_the_one_in_it() {
    for (z, side, other) in [(2, "E<RG>L", "E<TG>L"), (-3, "E<TG>L", "E<RG>L")] {
        let scene = format!(
            "screen 16 12\ncamera 0 -3 5 .5 x 30\nlight 8 4 2\nsphere 0 0 {z} 1\n\
             brdf 0 0 0 .04 .04 .04 .4 .9 .8 .7 1.5\nbox -50 -50 -90 100 100 90\n"
        );
        for integrator in INTEGRATORS {
            let settings = settings(integrator, Some(1));
            let prepared = prepared(&scene, &settings);
            let all = split(&job(&prepared, settings, 64, 1), &["EGL", side, other]);
            assert!(all[0].iter().flatten().any(|&x| x > 0.0), "{integrator:?}");
            assert_eq!(all[0], all[1], "{integrator:?}, {side}");
            assert!(
                all[2].iter().flatten().all(|&x| x == 0.0),
                "{integrator:?}, {other}"
            );
        }
    }
}
