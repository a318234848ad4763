//! The experiment of `vkpt converge` as a whole: its replicates are the pictures that a rendering makes, its seconds
//! are those of samples alone, and it sees an estimator that is wrong.

mod planted;
mod sobol;

use std::sync::atomic::AtomicBool;

use vkpt::metrics::convergence::{Metric, Reference};
use vkpt::metrics::flip::Viewing;
use vkpt::render::{DispatchLimits, Engine, Job, Replicates, Target};
use vkpt::settings::Settings;
use vkpt_lab::converge::{Measured, Plan, Variant, measure};

use crate::common;
use crate::common::render::{difference, job, on_device, outcome, prepared};
use crate::common::scenes::TABLE;

/// A floor under a lamp: connections find nearly all of its light.
const LIT: &str = "screen 24 16\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 2 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

static RUNNING: AtomicBool = AtomicBool::new(false);

/// Each of two replicates, rendered in alternation, is at each step equal to a rendering of its seed.
fn check_pictures(engine: &Engine, render: impl Fn(&Job) -> vkpt::film::Film) {
    let settings = Settings::default();
    let scene = prepared(TABLE, &settings);
    let any = job(&scene, settings, 1, 0);
    let mut replicates = Replicates::new(&any, engine, &[3, 11]).expect("ready");
    for spp in [1, 2, 5, 12] {
        for (i, seed) in [(0, 3), (1, 11)] {
            let took = replicates.advance(i, spp, &RUNNING).expect("samples");
            assert!(took.wall_s > 0.0 && took.gpu_s.is_none_or(|gpu| gpu <= took.wall_s));
            let rendered = render(&job(&scene, settings, spp, seed));
            assert_eq!(
                difference(&replicates.picture(i), &rendered),
                None,
                "{spp} spp, {seed}"
            );
            assert_eq!(replicates.done(i), spp);
        }
    }
    // A step that is already rendered takes no samples.
    replicates.advance(0, 7, &RUNNING).expect("nothing");
    assert_eq!(replicates.done(0), 12);
}

#[test]
fn replicates_equal_renderings() {
    check_pictures(&Engine::CpuF32, |job| outcome(job, &Target::CpuF32).film);
    let Some(device) = common::device() else {
        return;
    };
    let whole = DispatchLimits::of(device).expect("a probe");
    // One tile, several, and paths that continue from one dispatch to the next.
    let tiles = DispatchLimits {
        tile_pixels: 100,
        ..whole
    };
    let short = DispatchLimits {
        budget: 40,
        ..tiles
    };
    for limits in [whole, tiles, short] {
        let engine = Engine::Vulkan(device.clone(), limits);
        check_pictures(&engine, |job| on_device(job).expect("a device").film);
    }
}

fn plan() -> Plan {
    Plan {
        seeds: (0..6).collect(),
        seconds: 1e6,
        spp: 256,
        viewing: Viewing::default(),
    }
}

fn measured(job: &Job, reference: &Reference, engine: &Engine, plan: &Plan) -> Measured {
    let variant = [Variant {
        job,
        reference,
        finish: None,
    }];
    measure(&variant, engine, plan, &RUNNING, &mut |_| {}).expect("a curve")
}

#[test]
fn steps_are_whole_and_keep_to_the_time() {
    let settings = Settings::default();
    let scene = prepared(LIT, &settings);
    let job = job(&scene, settings, 1, 0);
    let film = outcome(&job, &Target::CpuF32).film;
    let reference = Reference::picture(film, None).expect("a picture");
    // No time at all: one step, because less would be nothing.
    let hurried = Plan {
        seconds: 1e-9,
        ..plan()
    };
    let one = measured(&job, &reference, &Engine::CpuF32, &hurried);
    assert_eq!(one.curves[0].steps.len(), 1);
    assert!(!one.interrupted && one.spent_s > hurried.seconds);
    let all = measured(
        &job,
        &reference,
        &Engine::CpuF32,
        &Plan { spp: 9, ..plan() },
    );
    let steps = &all.curves[0].steps;
    assert_eq!(
        steps.iter().map(|s| s.spp).collect::<Vec<_>>(),
        [1, 2, 4, 8]
    );
    for pair in steps.windows(2) {
        assert!(
            pair[0]
                .wall_s
                .iter()
                .zip(&pair[1].wall_s)
                .all(|(a, b)| a < b)
        );
    }
    let last: f64 = steps[3].wall_s.iter().sum();
    assert!((all.spent_s / last - 1.0).abs() < 1e-9, "{}", all.spent_s);
    // The first replicate's first sample is the reference itself.
    assert_eq!(steps[0].means(Metric::Mse)[0], 0.0);
    let variant = [Variant {
        job: &job,
        reference: &reference,
        finish: None,
    }];
    let stopped = AtomicBool::new(true);
    let none = measure(&variant, &Engine::CpuF32, &plan(), &stopped, &mut |_| {}).expect("a curve");
    assert!(none.interrupted && none.curves[0].steps.is_empty());
}
