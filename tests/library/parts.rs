//! Parts of a picture by the reference: however samples are divided, interrupted and resumed, they join to the part of
//! one rendering, bit for bit. Small pictures of many samples: the order of addition is tested.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use vkpt::film::Aov;
use vkpt::part::AnyPart;
use vkpt::prepared::Prepared;
use vkpt::render::{End, Job, Outcome, Progress, RenderError, Start, Target, Watch, render_from};
use vkpt::settings::{Integrator, Sampler, Settings};

use crate::common::render::{job, outcome, prepared};
use crate::common::scenes::TABLE;

const SPP: u32 = 700;
const TARGETS: [Target; 2] = [Target::CpuF32, Target::CpuF64];

/// Few pixels of a scene with glass, by each integrator; the first with moments of independent samples, the second with quarters.
fn cases() -> Vec<(Prepared, Settings, &'static [Aov])> {
    let case = |integrator| {
        let mut settings = Settings::default();
        settings.estimator.integrator = integrator;
        settings.estimator.sampler = match integrator {
            Integrator::Path => Sampler::Random,
            _ => Sampler::SobolQuarters,
        };
        let text = TABLE.replace("screen 32 24", "screen 4 3");
        let aovs: &[Aov] = match integrator {
            Integrator::Path => &[Aov::Stderr],
            Integrator::Light => &[Aov::Denoised],
            Integrator::Bidirectional => &[],
        };
        (prepared(&text, &settings), settings, aovs)
    };
    let all = [
        Integrator::Path,
        Integrator::Light,
        Integrator::Bidirectional,
    ];
    all.map(case).into()
}

fn from(job: &Job, target: &Target, start: &Start, watch: &mut dyn Watch) -> Outcome {
    render_from(job, target, start, &AtomicBool::new(false), watch).expect("a rendering")
}

fn part(job: &Job, target: &Target, range: &Range<u32>) -> AnyPart {
    let job = Job {
        spp: range.end,
        ..*job
    };
    let part = from(&job, target, &Start::At(range.start), &mut |_: Progress| {});
    assert_eq!((part.spp, part.end), (range.len() as u32, End::Complete));
    part.state.part
}

#[test]
fn parts_join_to_one_rendering() {
    for (scene, settings, aovs) in cases() {
        let job = Job {
            aovs,
            ..job(&scene, settings, SPP, 3)
        };
        for target in &TARGETS {
            let one = outcome(&job, target);
            for ranges in [
                &[0..1, 1..255, 255..SPP][..],
                &[0..256, 256..600, 600..613, 613..SPP],
            ] {
                let parts = ranges.iter().map(|range| part(&job, target, range));
                let joined = parts.reduce(|mut a, b| {
                    a.append(b, &mut |_, _| {}).expect("the next part");
                    a
                });
                let joined = joined.expect("parts");
                assert!(joined == one.state.part, "{target:?} {ranges:?}");
                assert!(joined.picture() == one.film, "{target:?} {ranges:?}");
                let stderr = aovs
                    .contains(&Aov::Stderr)
                    .then(|| joined.standard_errors());
                assert!(stderr == one.stderr, "{target:?} {ranges:?}");
            }
        }
    }
}

#[test]
fn a_sample_more_or_another_seed_is_a_difference() {
    let (scene, settings, aovs) = cases().remove(0);
    let job = Job {
        aovs,
        ..job(&scene, settings, SPP, 3)
    };
    let right = part(&job, &Target::CpuF32, &(0..SPP));
    assert!(part(&job, &Target::CpuF32, &(0..SPP)) == right);
    assert!(part(&job, &Target::CpuF32, &(0..SPP - 1)) != right);
    assert!(part(&Job { seed: 4, ..job }, &Target::CpuF32, &(0..SPP)) != right);
}

/// Ends a rendering after some slices.
struct Stopper<'a> {
    slices: u32,
    stop: &'a AtomicBool,
}

impl Watch for Stopper<'_> {
    fn progress(&mut self, _: Progress) {}

    fn reached(&mut self, so_far: &dyn Fn() -> Outcome) {
        self.slices = self.slices.saturating_sub(1);
        if self.slices == 0 {
            self.stop.store(true, Ordering::Relaxed);
        }
        assert!(so_far().spp > 0);
    }
}

#[test]
fn an_interrupted_rendering_goes_on_to_the_same_bits() {
    for (scene, settings, aovs) in cases() {
        let job = Job {
            aovs,
            ..job(&scene, settings, SPP, 5)
        };
        for target in &TARGETS {
            let one = outcome(&job, target);
            let mut start = Start::At(0);
            let mut pieces = 0;
            for slices in 1.. {
                let stop = AtomicBool::new(false);
                let mut watch = Stopper {
                    slices,
                    stop: &stop,
                };
                let piece = render_from(&job, target, &start, &stop, &mut watch);
                let piece = piece.expect("a rendering");
                pieces += 1;
                if piece.end == End::Complete {
                    assert!(piece.film == one.film && piece.state.part == one.state.part);
                    let errors = |o: &Outcome| -> Vec<_> {
                        o.state.errors.iter().map(|e| (e.spp, e.rel_mse)).collect()
                    };
                    assert_eq!(errors(&piece), errors(&one));
                    assert_eq!(piece.stats.rays, one.stats.rays);
                    assert_eq!(piece.stats.largest, one.stats.largest);
                    break;
                }
                start = Start::After(piece.state);
            }
            assert!(pieces > 3, "{pieces}: not interrupted");
        }
    }
}

#[test]
fn parts_of_another_job_are_refused() {
    let (scene, settings, _) = cases().remove(1);
    let job = job(&scene, settings, 3, 5);
    let left = outcome(&job, &Target::CpuF64).state;
    let longer = Job { spp: 9, ..job };
    let crop = Job {
        crop: Some([0, 0, 2, 2]),
        ..longer
    };
    let go_on = |job: &Job, target| {
        let start = Start::After(left.clone());
        render_from(
            job,
            target,
            &start,
            &AtomicBool::new(false),
            &mut |_: Progress| {},
        )
    };
    assert!(go_on(&longer, &Target::CpuF64).is_ok());
    for refused in [
        go_on(&longer, &Target::CpuF32),
        go_on(&crop, &Target::CpuF64),
    ] {
        assert!(matches!(refused, Err(RenderError::Start)), "{refused:?}");
    }
}
