//! Worlds of radiance 1: nothing in them is brighter.

use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::TestCaseResult;
use vkpt::prepared::NONE;
use vkpt::settings::{Absorption, Connect, Fresnel, Roulette, Sampler, Settings};

use super::case::{Case, looking_in, world};
use super::material::lossy;
use super::samples::{By, COMPOSED, Made, made};
use super::{check_property, long_seeds};

const FILE: &str = "tests/device/random_scenes/regressions/furnace.txt";
const SPP: u32 = 8;
/// Bounces of a path at most, by which rounding is bounded.
const DEPTH: u32 = 64;
/// 128 roundings a vertex, as `vkpt check` counts them.
const ROUNDING: f64 = DEPTH as f64 * 128.0 / 16_777_216.0;

/// A surface that a path meets absorbs some of its light and adds none; radiance scaling comes to 1 along a path that begins
/// and ends in air. Roulette by throughput raises no throughput above 1.
fn settings() -> impl Strategy<Value = Settings> {
    (
        select(vec![None, Some(Fresnel::Exact), Some(Fresnel::Schlick)]),
        select(vec![Absorption::Segment, Absorption::Term]),
        any::<bool>(),
        select(vec![Roulette::Throughput, Roulette::Off]),
        select(vec![Sampler::Sobol, Sampler::Random]),
    )
        .prop_map(
            |(fresnel, absorption, radiance_scaling, roulette, sampler)| {
                let mut s = Settings::default();
                (s.model.fresnel, s.model.absorption) = (fresnel, absorption);
                (s.model.radiance_scaling, s.model.max_depth) = (radiance_scaling, Some(DEPTH));
                (s.estimator.roulette, s.estimator.sampler) = (roulette, sampler);
                s.estimator.connect = Connect::Bsdf;
                s
            },
        )
}

/// Any shapes of materials that emit no light, in a world of radiance 1.
pub fn furnace() -> impl Strategy<Value = Case> {
    (
        looking_in(3.0..8.0f64),
        world(lossy()),
        settings(),
        any::<u32>(),
    )
        .prop_map(|(eye, world, settings, seed)| {
            let camera = eye.line(world.scale, world.offset);
            Case {
                text: format!("screen 4 4\n{camera}\nbackground 1 1 1\n{}", world.lines()),
                settings,
                seed,
            }
        })
}

/// The brightest sample, if it is brighter than the world.
pub fn brighter(all: &[Made]) -> Option<String> {
    let above = |s: &[f64; 3]| !s.iter().all(|x| *x <= 1.0 + ROUNDING);
    all.iter().find_map(|made| {
        let i = made.radiances.iter().position(above)?;
        let (pixel, sample) = (i / made.spp as usize, i % made.spp as usize);
        Some(format!(
            "{}: {:?} in pixel {pixel}, sample {sample}",
            made.by, made.radiances[i]
        ))
    })
}

fn nothing_is_brighter(case: &Case, by: By) -> TestCaseResult {
    let prepared = case.prepared();
    // In glass all radiance is n² times as large. Glass that overlaps glass is outside the model, and what an eye on its surface
    // sees is left to rounding: both give warnings.
    let warnings = ["overlap", "the eye is on the surface"];
    let warned = prepared
        .warnings
        .iter()
        .any(|w| warnings.iter().any(|part| w.contains(part)));
    if prepared.eye_medium == NONE && !warned {
        let brightest = made(by, case, &prepared, SPP).and_then(|all| brighter(&all));
        prop_assert_eq!(brightest, None);
    }
    Ok(())
}

#[test]
fn no_sample_of_the_references_is_brighter_than_the_world() {
    check_property(FILE, 1500, 8, furnace(), |case| {
        nothing_is_brighter(case, By::References)
    });
}

#[test]
fn no_sample_of_the_device_is_brighter_than_the_world() {
    check_property(FILE, 12, 9, furnace(), |case| {
        nothing_is_brighter(case, COMPOSED)
    });
}

#[test]
#[ignore = "minutes"]
fn no_sample_of_the_references_is_brighter_than_the_world_in_many_scenes() {
    for seed in long_seeds() {
        check_property(FILE, 10_000, seed, furnace(), |case| {
            nothing_is_brighter(case, By::References)
        });
    }
}

#[test]
#[ignore = "minutes"]
fn no_sample_of_the_device_is_brighter_than_the_world_in_many_scenes() {
    for seed in long_seeds() {
        check_property(FILE, 100, seed, furnace(), |case| {
            nothing_is_brighter(case, COMPOSED)
        });
    }
}
