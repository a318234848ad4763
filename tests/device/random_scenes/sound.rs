//! No sample is broken, by any renderer, and the device's are cpu-f32's.

use proptest::test_runner::TestCaseResult;
use proptest::{prop_assert, prop_assert_eq};
use vkpt::prepared::Prepared;
use vkpt::render::{Dropped, Target};

use super::bound::albedo_anywhere;
use super::case::{Case, any_case};
use super::samples::{By, COMPOSED, Made, made, rounds_as_the_reference};
use super::{check_property, long_seeds};
use crate::common::render::{job, outcome};

/// Samples a pixel.
const SPP: u32 = 8;

/// The errors of the samples; `None` if there are none. If paths may `grow`, they may end at the scalar's infinity,
/// where the film drops and counts them.
pub fn broken(all: &[Made], grow: bool) -> Option<String> {
    let wrong = |x: f64| x < 0.0 || x.is_nan() || (x.is_infinite() && !grow);
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
pub fn first_unequal(all: &[Made]) -> Option<String> {
    let bits = |s: &[f64; 3]| s.map(f64::to_bits);
    let [device, f32, ..] = all else { return None };
    let pairs = device.radiances.iter().zip(&f32.radiances);
    let (i, (a, b)) = pairs.enumerate().find(|(_, (a, b))| bits(a) != bits(b))?;
    Some(format!("sample {i}: {a:?} by the device, {b:?} by cpu-f32"))
}

/// Whether some surface may return more light than it gets: between two of these, light grows without end.
fn may_grow(prepared: &Prepared) -> bool {
    prepared.materials.iter().any(|m| albedo_anywhere(m) > 1.0)
}

/// The picture that cpu-f32 makes of the same samples: finite, not negative, and nothing is dropped on the way.
fn picture_is_whole(case: &Case, prepared: &Prepared) -> TestCaseResult {
    let job = job(prepared, case.settings, SPP, case.seed);
    let outcome = outcome(&job, &Target::CpuF32);
    let values = outcome.film.rgb.as_flattened();
    prop_assert!(
        values.iter().all(|x| x.is_finite() && *x >= 0.0),
        "{:?}",
        values
    );
    if !may_grow(prepared) {
        prop_assert_eq!(outcome.stats.dropped, Dropped::default());
    }
    Ok(())
}

fn nothing_is_broken(case: &Case, by: By) -> TestCaseResult {
    let prepared = case.prepared();
    let Some(all) = made(by, case, &prepared, SPP) else {
        return Ok(());
    };
    prop_assert_eq!(broken(&all, may_grow(&prepared)), None);
    if matches!(by, By::References) {
        return picture_is_whole(case, &prepared);
    }
    if rounds_as_the_reference() {
        prop_assert_eq!(first_unequal(&all), None);
    }
    Ok(())
}

/// Their seeds.
const FILE: &str = "tests/device/random_scenes/regressions/sound.txt";

#[test]
fn no_sample_of_the_references_is_broken() {
    check_property(FILE, 1500, 6, any_case(), |case| {
        nothing_is_broken(case, By::References)
    });
}

#[test]
fn no_sample_of_the_device_is_broken() {
    check_property(FILE, 12, 7, any_case(), |case| {
        nothing_is_broken(case, COMPOSED)
    });
}

#[test]
#[ignore = "minutes"]
fn no_sample_of_the_references_is_broken_in_many_scenes() {
    for seed in long_seeds() {
        check_property(FILE, 10_000, seed, any_case(), |case| {
            nothing_is_broken(case, By::References)
        });
    }
}

#[test]
#[ignore = "minutes"]
fn no_sample_of_the_device_is_broken_in_many_scenes() {
    for seed in long_seeds() {
        check_property(FILE, 100, seed, any_case(), |case| {
            nothing_is_broken(case, COMPOSED)
        });
    }
}
