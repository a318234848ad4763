//! The error that a rendering reports and the conditions that may end it, by the device and by the reference.

use std::sync::atomic::AtomicBool;

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::film::Film;
use vkpt::metrics::{Errors, Pair};
use vkpt::render::{DispatchLimits, End, ErrorAt, Job, Outcome, Target, Until, render};
use vkpt::settings::{Connect, Settings};

use crate::common;
use crate::common::render::{difference, job, on_device, on_device_within, outcome, prepared};
use crate::common::scenes::{SMOOTH, TABLE, WIDE};
use crate::common::settings::independent;

/// The job by the reference, and on the device where there is one.
fn outcomes(job: &Job) -> Vec<(&'static str, Outcome)> {
    let f32 = ("cpu-f32", outcome(job, &Target::CpuF32));
    let f64 = ("cpu-f64", outcome(job, &Target::CpuF64));
    let gpu = on_device(job).map(|o| ("the device", o));
    [f32, f64].into_iter().chain(gpu).collect()
}

/// All results except the time that it took.
fn timeless(errors: &[ErrorAt]) -> Vec<ErrorAt> {
    let without = |e: &ErrorAt| ErrorAt { seconds: 0.0, ..*e };
    errors.iter().map(without).collect()
}

fn until(seconds: Option<f64>, rel_mse: Option<f64>) -> Until {
    Until { seconds, rel_mse }
}

// ---- the curve

#[test]
fn the_error_is_reported_after_powers_of_two_and_at_the_end() {
    let scene = prepared(TABLE, &Settings::default());
    for (spp, expected) in [
        (1, vec![1]),
        (2, vec![1, 2]),
        (16, vec![1, 2, 4, 8, 16]),
        (21, vec![1, 2, 4, 8, 16, 21]),
    ] {
        for (name, outcome) in outcomes(&job(&scene, Settings::default(), spp, 1)) {
            let reported: Vec<u32> = outcome.state.errors.iter().map(|e| e.spp).collect();
            assert_eq!(reported, expected, "{name}");
            let known = |e: &ErrorAt| e.rel_mse.is_some() == (e.spp > 1);
            assert!(outcome.state.errors.iter().all(known), "{name}");
            assert!(
                outcome
                    .state
                    .errors
                    .is_sorted_by(|a, b| a.seconds <= b.seconds),
                "{name}"
            );
            assert_eq!(outcome.end, End::Complete, "{name}");
        }
    }
}

/// The estimate is a pure function of sums that are the same to the bit; neither tiles nor dispatches are seen in it.
#[test]
fn the_device_reports_the_error_of_the_reference() {
    let Some(device) = common::cpu_driver() else {
        return;
    };
    for text in [TABLE, SMOOTH, WIDE] {
        let scene = prepared(text, &Settings::default());
        let limits = DispatchLimits::of(device).expect("a probe");
        let job = job(&scene, Settings::default(), 9, 1);
        let reference = timeless(&outcome(&job, &Target::CpuF32).state.errors);
        let device = on_device(&job).expect("a device");
        assert_eq!(timeless(&device.state.errors), reference, "{text}");
        for (tile_pixels, budget) in [(7, 4000), (100, 40), (1 << 16, 1)] {
            let limits = DispatchLimits {
                tile_pixels,
                budget,
                ..limits
            };
            let other = on_device_within(&job, limits).expect("the same device");
            assert_eq!(timeless(&other.state.errors), reference, "{limits:?}");
        }
    }
}

// ---- honesty

/// The inside of a white-lit world seen on a big Lambert ball, Kd under a sky of 1: every pixel converges to Kd. Half
/// of the noise comes from light that is sought by its direction alone.
const LAMBERT: &str = "screen 40 40
camera 0 0 5 .15
background 1 1 1
brdf .8 .5 .2 0 0 0 1
sphere 0 0 0 3
";

/// α = 1e-4 for too many misses at 5 % each; estimates planted a fifth off must fail the same test.
#[test]
fn intervals_contain_the_error_of_a_lambert_ball() {
    let mut settings = Settings::default();
    settings.estimator.connect = Connect::Light;
    let scene = prepared(LAMBERT, &settings);
    let truth = Film {
        width: 40,
        height: 40,
        rgb: vec![[0.8, 0.5, 0.2]; 1600],
    };
    let p = |scale: f64| {
        let missed = (0..60).filter(|&seed| {
            let outcome = outcome(&job(&scene, settings, 16, seed), &Target::CpuF32);
            let pair = Pair::new(&outcome.film, &truth).expect("two pictures");
            let true_error = scale * Errors::of(&pair).rel_mse.all;
            let last = outcome.state.errors.last().and_then(|e| e.rel_mse);
            let [low, high] = last.and_then(|e| e.interval.ok()).expect("an interval");
            assert!(low > 0.0 && high < 2.0 * low);
            true_error < low || true_error > high
        });
        let (n, k) = (60, missed.count() as u64);
        println!("× {scale}: {k} of {n} miss");
        let binomial = Binomial::new(0.05, n).expect("a probability");
        if k == 0 { 1.0 } else { binomial.sf(k - 1) }
    };
    assert!(p(1.0) > 1e-4);
    assert!(p(1.2) < 1e-4);
    assert!(p(1.0 / 1.2) < 1e-4);
}

// ---- ends

/// A rendering that ends early leaves the picture with that many samples.
fn equals_its_spp(job: &Job, target: Option<&Target>, end: End) -> u32 {
    let render = |job: &Job| match target {
        Some(target) => Some(outcome(job, target)),
        None => on_device(job),
    };
    let Some(ended) = render(job) else { return 0 };
    assert_eq!(ended.end, end, "{target:?}");
    let plain = Job {
        until: Until::default(),
        spp: ended.spp,
        ..*job
    };
    let plain = render(&plain).expect("a device");
    assert_eq!(difference(&ended.film, &plain.film), None, "{target:?}");
    assert_eq!(ended.state.errors.last().map(|e| e.spp), Some(ended.spp));
    assert_eq!(
        timeless(&ended.state.errors),
        timeless(&plain.state.errors),
        "{target:?}"
    );
    ended.spp
}

const TARGETS: [Option<&Target>; 3] = [None, Some(&Target::CpuF32), Some(&Target::CpuF64)];

#[test]
fn a_time_ends_with_the_picture_of_the_samples_done() {
    let scene = prepared(TABLE, &Settings::default());
    let endless = job(&scene, Settings::default(), 1 << 31, 1);
    for seconds in [1e-9, 0.2] {
        let timed = Job {
            until: until(Some(seconds), None),
            ..endless
        };
        for target in TARGETS {
            let spp = equals_its_spp(&timed, target, End::Time);
            assert!(seconds > 0.1 || spp <= 1, "{target:?}: {spp} samples");
        }
    }
}

/// Once half a second is spent a slice of at most the time left has begun: a machine with much else to do may take
/// longer for it, not shorter.
#[test]
fn a_time_is_spent() {
    let scene = prepared(TABLE, &Settings::default());
    let job = Job {
        until: until(Some(0.5), None),
        ..job(&scene, Settings::default(), 1 << 31, 1)
    };
    for (name, outcome) in outcomes(&job) {
        assert!(outcome.stats.render_s >= 0.5, "{name}");
        assert!(
            outcome.stats.render_s < 2.0,
            "{name}: {} s",
            outcome.stats.render_s
        );
    }
}

/// The points at which the error is estimated depend on no clock: any device ends at the same sample.
#[test]
fn an_error_ends_with_the_picture_of_the_samples_done() {
    let scene = prepared(SMOOTH, &Settings::default());
    let endless = job(&scene, independent(), 1 << 31, 1);
    let mut reached = Vec::new();
    for target in [3e-3, 3e-4] {
        let job = Job {
            until: until(None, Some(target)),
            ..endless
        };
        let spp = TARGETS.map(|renderer| equals_its_spp(&job, renderer, End::Error));
        assert!(spp[0] == 0 || spp[0] == spp[1], "{spp:?}");
        let last = outcome(
            &Job {
                spp: spp[1],
                until: Until::default(),
                ..job
            },
            &Target::CpuF32,
        );
        let interval = last
            .state
            .errors
            .last()
            .and_then(|e| e.rel_mse?.interval.ok());
        assert!(interval.expect("an interval")[1] < target);
        reached.push(spp[1]);
    }
    // A tenth of the error takes about ten times the samples.
    assert!(reached[1] > 4 * reached[0], "{reached:?}");
}

#[test]
fn samples_end_a_rendering_before_time_and_error() {
    let scene = prepared(TABLE, &Settings::default());
    let job = Job {
        until: until(Some(1e6), Some(1e-12)),
        ..job(&scene, Settings::default(), 5, 1)
    };
    for target in TARGETS {
        equals_its_spp(&job, target, End::Complete);
    }
}

#[test]
fn progress_is_that_of_the_limit_that_ends_it() {
    let scene = prepared(TABLE, &Settings::default());
    let job = Job {
        until: until(Some(0.3), None),
        ..job(&scene, Settings::default(), 1 << 31, 1)
    };
    let mut fractions = Vec::new();
    let stop = AtomicBool::new(false);
    let outcome = render(&job, &Target::CpuF32, &stop, &mut |p| {
        fractions.push(p.fraction)
    });
    assert_eq!(outcome.expect("a rendering").end, End::Time);
    assert!(fractions.is_sorted() && fractions.iter().all(|f| (0.0..=1.0).contains(f)));
    assert!(fractions.last().is_some_and(|&f| f > 0.5), "{fractions:?}");
}
