//! One rendering on several devices: the bits of one, whichever device made which samples.

use std::sync::atomic::AtomicBool;

use vkpt::film::Aov;
use vkpt::gpu::Selector;
use vkpt::render::{
    End, Job, Outcome, Progress, RenderError, Start, Target, Until, render_several,
};
use vkpt::settings::{Integrator, Sampler, Settings};

use crate::common::render::{job, outcome, prepared};
use crate::common::scenes::TABLE;
use crate::common::{cpu_driver, selector};

fn several(job: &Job, targets: &[Target], start: &Start) -> Result<Outcome, RenderError> {
    let stop = AtomicBool::new(false);
    render_several(job, targets, start, &stop, &mut |_: Progress| {})
}

fn errors(outcome: &Outcome) -> Vec<(u32, Option<f64>)> {
    let all = outcome.state.errors.iter();
    all.map(|e| (e.spp, e.rel_mse.map(|r| r.estimate)))
        .collect()
}

#[test]
fn several_devices_make_the_bits_of_one() {
    if cpu_driver().is_none() {
        return;
    }
    let device = Target::Vulkan(selector());
    let groups = [
        vec![device.clone(), device.clone()],
        vec![Target::CpuF32, device.clone(), Target::CpuF32],
    ];
    for integrator in [Integrator::Path, Integrator::Bidirectional] {
        let mut settings = Settings::default();
        settings.estimator.integrator = integrator;
        settings.estimator.sampler = Sampler::Random;
        let text = TABLE.replace("screen 32 24", "screen 9 7");
        let scene = prepared(&text, &settings);
        let job = Job {
            aovs: &[Aov::Stderr],
            ..job(&scene, settings, 3000, 1)
        };
        let one = outcome(&job, &Target::CpuF32);
        for targets in &groups {
            let made = several(&job, targets, &Start::At(0)).expect("a rendering");
            assert_eq!(made.end, End::Complete);
            assert!(
                made.state.part == one.state.part,
                "{integrator:?} {targets:?}"
            );
            assert!(made.film == one.film && made.stderr == one.stderr);
            assert_eq!(errors(&made), errors(&one));
            assert_eq!(made.stats.rays, one.stats.rays);
            assert_eq!(made.stats.largest, one.stats.largest);
            // On from where one device has ended.
            let half = Job { spp: 1111, ..job };
            let start = Start::After(outcome(&half, &Target::CpuF32).state);
            let made = several(&job, targets, &start).expect("a rendering");
            assert!(
                made.state.part == one.state.part,
                "{integrator:?} {targets:?}"
            );
            assert_eq!(errors(&made), errors(&one));
        }
    }
}

#[test]
fn they_end_by_time_and_by_error() {
    if cpu_driver().is_none() {
        return;
    }
    let settings = Settings::default();
    let scene = prepared(TABLE, &settings);
    let endless = job(&scene, settings, u32::MAX, 1);
    let targets = [Target::Vulkan(selector()), Target::CpuF32];
    for until in [
        Until {
            seconds: Some(2.0),
            rel_mse: None,
        },
        Until {
            seconds: None,
            rel_mse: Some(1e-2),
        },
    ] {
        let made = several(&Job { until, ..endless }, &targets, &Start::At(0));
        let made = made.expect("a rendering");
        let end = if until.seconds.is_some() {
            End::Time
        } else {
            End::Error
        };
        assert_eq!(made.end, end);
        let again = outcome(
            &Job {
                spp: made.spp,
                ..endless
            },
            &Target::CpuF32,
        );
        assert!(made.film == again.film, "{} samples", made.spp);
        assert_eq!(made.state.errors.last().map(|e| e.spp), Some(made.spp));
    }
}

#[test]
fn a_device_that_is_not_there_is_an_error() {
    let settings = Settings::default();
    let scene = prepared(TABLE, &settings);
    let job = job(&scene, settings, 100, 1);
    let none = Target::Vulkan(Selector::Name("no such device".to_owned()));
    let made = several(&job, &[Target::CpuF32, none], &Start::At(0));
    assert!(made.is_err_and(|error| error.is_no_device()));
}
