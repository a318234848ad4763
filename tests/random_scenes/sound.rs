//! No sample is broken, by whatever renderer, and the device's are cpu-f32's.

use proptest::prop_assert_eq;
use proptest::test_runner::TestCaseResult;
use vkpt::prepared::Prepared;

use crate::bound::albedo_anywhere;
use crate::case::{Case, any_case};
use crate::samples::{By, COMPOSED, Made, made, rounds_as_the_reference};
use crate::{hold, long_seeds};

/// Samples a pixel.
const SPP: u32 = 8;

/// What is wrong with the samples; `None` where nothing is.
pub fn broken(all: &[Made]) -> Option<String> {
    let wrong = |x: f64| !x.is_finite() || x < 0.0;
    all.iter().find_map(|made| {
        let i = made
            .radiances
            .iter()
            .position(|s| s.iter().any(|x| wrong(*x)))?;
        let (pixel, sample) = (i / made.spp as usize, i % made.spp as usize);
        Some(format!(
            "{}: {:?} in pixel {pixel}, sample {sample}",
            made.by, made.radiances[i]
        ))
    })
}

/// Where the device, which comes first, differs from cpu-f32 in a bit.
pub fn parted(all: &[Made]) -> Option<String> {
    let bits = |s: &[f64; 3]| s.map(f64::to_bits);
    let [device, f32, ..] = all else { return None };
    let pairs = device.radiances.iter().zip(&f32.radiances);
    let (i, (a, b)) = pairs.enumerate().find(|(_, (a, b))| bits(a) != bits(b))?;
    Some(format!("sample {i}: {a:?} by the device, {b:?} by cpu-f32"))
}

/// Light that each surface makes more of grows without bound between two: such paths end after so many bounces.
const DEPTH_OF_GAIN: u32 = 24;

/// The case with its scene, and with its paths kept from growing beyond single precision.
fn tamed(case: &Case) -> (Case, Prepared) {
    let (mut case, prepared) = (case.clone(), case.prepared());
    if prepared.materials.iter().any(|m| albedo_anywhere(m) > 1.0) {
        let depth = &mut case.settings.model.max_depth;
        *depth = Some(depth.map_or(DEPTH_OF_GAIN, |d| d.min(DEPTH_OF_GAIN)));
    }
    (case, prepared)
}

fn nothing_is_broken(case: &Case, by: By) -> TestCaseResult {
    let (case, prepared) = tamed(case);
    let Some(all) = made(by, &case, &prepared, SPP) else {
        return Ok(());
    };
    prop_assert_eq!(broken(&all), None);
    if matches!(by, By::All(_)) && rounds_as_the_reference() {
        prop_assert_eq!(parted(&all), None);
    }
    Ok(())
}

/// Their seeds.
const FILE: &str = "tests/random_scenes/regressions/sound.txt";

#[test]
fn no_sample_of_the_references_is_broken() {
    hold(FILE, 1500, 6, any_case(), |case| {
        nothing_is_broken(case, By::References)
    });
}

#[test]
fn no_sample_of_the_device_is_broken() {
    hold(FILE, 12, 7, any_case(), |case| {
        nothing_is_broken(case, COMPOSED)
    });
}

#[test]
#[ignore = "minutes"]
fn no_sample_of_the_references_is_broken_in_many_scenes() {
    for seed in long_seeds() {
        hold(FILE, 10_000, seed, any_case(), |case| {
            nothing_is_broken(case, By::References)
        });
    }
}

#[test]
#[ignore = "minutes"]
fn no_sample_of_the_device_is_broken_in_many_scenes() {
    for seed in long_seeds() {
        hold(FILE, 100, seed, any_case(), |case| {
            nothing_is_broken(case, COMPOSED)
        });
    }
}
