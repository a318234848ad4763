//! `--aov stderr`: it does not change the picture, to the bit; the device and the reference report the same errors, and these
//! are the errors that pictures have.

use std::sync::atomic::{AtomicBool, Ordering};

use statrs::distribution::{ChiSquared, ContinuousCDF};
use vkpt::film::{Aov, Film};
use vkpt::prepared::Prepared;
use vkpt::render::{DISPATCH_TIME, DispatchLimits, End, Job, Outcome, Target, render};
use vkpt::settings::Settings;

use crate::common;
use crate::common::render::{difference, job, on_device, on_device_within, outcome, prepared};
use crate::common::scenes::{SMOOTH, TABLE, WIDE};
use crate::common::settings::independent;
use crate::common::stats::sidak;

const STDERR: &[Aov] = &[Aov::Stderr];

fn with_errors(scene: &Prepared, settings: Settings, spp: u32, seed: u32) -> Job<'_> {
    Job {
        aovs: STDERR,
        ..job(scene, settings, spp, seed)
    }
}

/// By either sampler: from the spread of samples, and from their two groups.
fn both() -> [Settings; 2] {
    [independent(), Settings::default()]
}

/// The job by the reference, and on the device where there is one.
fn outcomes(job: &Job) -> Vec<(&'static str, Outcome)> {
    let cpu = ("cpu-f32", outcome(job, &Target::CpuF32));
    let gpu = on_device(job).map(|o| ("the device", o));
    [cpu].into_iter().chain(gpu).collect()
}

fn errors(outcome: Outcome) -> Film {
    outcome.stderr.expect("standard errors")
}

fn same(a: &Film, b: &Film, what: &str) {
    if let Some(difference) = difference(a, b) {
        panic!("{what}: {difference}");
    }
}

// ---- bits

#[test]
fn the_picture_is_the_same_with_and_without() {
    for text in [TABLE, SMOOTH, WIDE] {
        let scene = prepared(text, &Settings::default());
        for settings in both() {
            let with = with_errors(&scene, settings, 6, 1);
            let without = Job { aovs: &[], ..with };
            for ((name, a), (_, b)) in outcomes(&with).into_iter().zip(outcomes(&without)) {
                same(&a.film, &b.film, name);
                assert!(a.stderr.is_some() && b.stderr.is_none(), "{name}");
                assert_eq!(a.stats.rays, b.stats.rays, "{name}");
            }
        }
    }
}

#[test]
fn the_device_reports_the_errors_of_the_reference() {
    if common::cpu_driver().is_none() {
        return;
    }
    for text in [TABLE, SMOOTH, WIDE] {
        let scene = prepared(text, &Settings::default());
        for (settings, spp) in both().into_iter().flat_map(|s| [(s, 2), (s, 9)]) {
            let job = with_errors(&scene, settings, spp, 1);
            let device = errors(on_device(&job).expect("a device"));
            let reference = errors(outcome(&job, &Target::CpuF32));
            same(&device, &reference, &format!("{spp} samples of\n{text}"));
            assert!(device.rgb.iter().flatten().any(|&e| e > 0.0));
        }
    }
}

#[test]
fn crop_tiles_and_dispatches_leave_no_trace() {
    both().into_iter().for_each(crop_and_limits_leave_no_trace);
}

fn crop_and_limits_leave_no_trace(settings: Settings) {
    let scene = prepared(TABLE, &settings);
    let whole = with_errors(&scene, settings, 6, 1);
    let [left, top, right, bottom] = [5, 3, 22, 20];
    let cropped = Job {
        crop: Some([left, top, right, bottom]),
        ..whole
    };
    for ((name, whole), (_, part)) in outcomes(&whole).into_iter().zip(outcomes(&cropped)) {
        let whole = errors(whole);
        let rows = whole
            .rgb
            .chunks(32)
            .take(bottom as usize)
            .skip(top as usize);
        let piece = Film {
            width: right - left,
            height: bottom - top,
            rgb: rows
                .flat_map(|row| row[left as usize..right as usize].to_vec())
                .collect(),
        };
        same(&errors(part), &piece, name);
    }
    let Some(device) = on_device(&whole).map(errors) else {
        return;
    };
    for (tile_pixels, budget) in [(7, 4000), (100, 40), (1 << 16, 1), (768, 40)] {
        let limits = DispatchLimits {
            tile_pixels,
            budget,
            read_first: true,
            storage_buffer: 1 << 27,
            dispatch_time: DISPATCH_TIME,
        };
        let other = on_device_within(&whole, limits).expect("the same device");
        same(&device, &errors(other), &format!("{limits:?}"));
    }
}

/// Slices differ from run to run, with the time that they take; so does the sample at which a rendering is stopped.
#[test]
fn an_interruption_leaves_the_errors_of_the_samples_done() {
    let scene = prepared(TABLE, &Settings::default());
    for (settings, least) in both().into_iter().flat_map(|s| [(s, 1), (s, 5)]) {
        let stop = AtomicBool::new(false);
        let stopped = render(
            &with_errors(&scene, settings, 1 << 31, 1),
            &Target::CpuF32,
            &stop,
            &mut |p| stop.store(p.samples_done >= least, Ordering::Relaxed),
        )
        .expect("a rendering");
        assert_eq!(stopped.end, End::Interrupted);
        let again = outcome(
            &with_errors(&scene, settings, stopped.spp, 1),
            &Target::CpuF32,
        );
        assert_eq!(stopped.stderr, again.stderr);
        // The first slice is of one sample, of which there is no estimate.
        assert_eq!(stopped.stderr.is_none(), least == 1);
    }
}

/// Every camera ray hits the emitter: all samples are equal, and so is their mean.
#[test]
fn where_all_samples_are_equal_the_error_is_0() {
    let scene = prepared(
        "screen 4 3\ncamera 0 0 5 0.1\nlight .1 .7 3\nsphere 0 0 0 3\n",
        &Settings::default(),
    );
    for settings in both() {
        for (name, outcome) in outcomes(&with_errors(&scene, settings, 48, 1)) {
            assert!(outcome.film.rgb.iter().all(|p| p[0] > 0.0), "{name}");
            assert_eq!(errors(outcome).rgb, [[0.0; 3]; 12], "{name}");
        }
    }
}

// ---- honesty

/// Side of a block of pixels: of its 25 × 32 samples the mean is nearly normal.
const BLOCK: usize = 5;
const SPP: u32 = 32;

/// A box on a floor under a ball of light and a sky: shadows, penumbrae, light from one surface to another.
const DIFFUSE: &str = "screen 160 120
camera 0 -6 3 .35 x 65
background .3 .4 .6
light 6 5 4
sphere 0 0 4 1
brdf .6 .5 .4 0 0 0 1
box -5 -5 -.1 10 10 .1
sphere -1 0 .8 .8
box .4 -.5 .002 1.1 1.1 1.1
";

/// Two renderings of independent seeds, with their errors.
fn pair(scene: &Prepared, seeds: [u32; 2]) -> [(Film, Film); 2] {
    seeds.map(|seed| {
        let outcome = outcome(
            &with_errors(scene, independent(), SPP, seed),
            &Target::CpuF32,
        );
        (outcome.film.clone(), errors(outcome))
    })
}

/// z = (mean a − mean b)/√(stderr a² + stderr b²) of each block in one channel; blocks without any error are omitted.
fn z_scores(pair: &[(Film, Film); 2], channel: usize, scale: f64) -> Vec<f64> {
    let [(a, error_a), (b, error_b)] = pair;
    let (width, height) = (a.width as usize, a.height as usize);
    let value = |film: &Film, i: usize| f64::from(film.rgb[i][channel]);
    let mut scores = Vec::new();
    for top in (0..height).step_by(BLOCK) {
        for left in (0..width).step_by(BLOCK) {
            let pixels = (0..BLOCK * BLOCK).map(|k| (top + k / BLOCK) * width + left + k % BLOCK);
            let (mut off, mut variance) = (0.0, 0.0);
            for i in pixels {
                off += value(a, i) - value(b, i);
                variance += scale.powi(2) * (value(error_a, i).powi(2) + value(error_b, i).powi(2));
            }
            if variance > 0.0 {
                scores.push(off / variance.sqrt());
            }
        }
    }
    scores
}

/// Two-sided p-value of the scores having variance 1: Σ z² is chi-square distributed.
fn p_of_unit_variance(scores: &[f64]) -> f64 {
    let sum: f64 = scores.iter().map(|z| z * z).sum();
    let chi = ChiSquared::new(scores.len() as f64).expect("one score or more");
    2.0 * chi.cdf(sum).min(chi.sf(sum))
}

/// Blocks of independent renderings differ by as much as their errors say; by errors planted a fifth too large or too
/// small they do not. α = 1e-3 over the three channels (Šidák).
#[test]
fn reported_errors_are_those_of_pictures() {
    let scene = prepared(DIFFUSE, &Settings::default());
    let pairs = [pair(&scene, [1, 2]), pair(&scene, [3, 4])];
    let p = |scale: f64, channel: usize| {
        let scores: Vec<f64> = pairs
            .iter()
            .flat_map(|pair| z_scores(pair, channel, scale))
            .collect();
        let variance = scores.iter().map(|z| z * z).sum::<f64>() / scores.len() as f64;
        let p = p_of_unit_variance(&scores);
        println!(
            "× {scale}, channel {channel}: {} blocks, variance {variance:.3}, p = {p:.2e}",
            scores.len()
        );
        p
    };
    let alpha = sidak(1e-3, 3);
    for channel in 0..3 {
        assert!(p(1.0, channel) > alpha);
        for planted in [1.2, 1.0 / 1.2] {
            assert!(p(planted, channel) < alpha);
        }
    }
}
