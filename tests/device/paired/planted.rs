//! Differences that must be found: other random numbers, another decision, one bit in one sample.

use vkpt::kernel::{OwnFile, file};
use vkpt::metrics::paired::Verdict;
use vkpt::render::{Job, KernelChoice};
use vkpt::sample::PairedSample;
use vkpt::settings::{Integrator, Settings};

use super::{compared, samples};
use crate::common::cpu_driver;
use crate::common::render::{job, prepared};
use crate::common::scenes::{INSIDE, SMOOTH, TABLE};
use crate::common::settings::by;
use crate::common::stats::{p_of_mean, sidak};

fn table(seed: u32) -> Option<Vec<PairedSample>> {
    let settings = Settings::default();
    samples(&job(&prepared(TABLE, &settings), settings, 16, seed))
}

/// Another seed is a renderer that decides otherwise, but without bias; a quarter less light on every path is one.
/// Two seeds diverge in a third of the paths: the others see the background, or the floor in the light.
#[test]
fn other_paths_part_without_bias_and_darker_ones_with() {
    let (Some(mut samples), Some(others)) = (table(1), table(2)) else {
        return;
    };
    for (s, other) in samples.iter_mut().zip(&others) {
        s.f64 = other.f64;
    }
    let [_, pair] = compared(&samples);
    assert!(
        pair.together < pair.paths * 4 / 5,
        "{} together",
        pair.together
    );
    assert!(
        matches!(pair.diverged.verdict(), Verdict::Unbiased(_)),
        "{pair:?}"
    );
    for s in &mut samples {
        s.f64.radiance = s.f64.radiance.map(|x| 0.75 * x);
    }
    let [_, pair] = compared(&samples);
    assert!(
        matches!(pair.diverged.verdict(), Verdict::Biased(_)),
        "{pair:?}"
    );
}

/// A hundredth more light on every path: a device that is wrong everywhere stays together, and is not close.
#[test]
fn a_hundredth_of_all_light_is_the_median_difference() {
    let Some(mut samples) = table(1) else { return };
    for s in &mut samples {
        s.f64.radiance = s.f64.radiance.map(|x| 1.01 * x);
    }
    let [_, pair] = compared(&samples);
    let median = pair.closeness.quantile(0.5).expect("light");
    assert!(
        (median / (1.0 - 1.0 / 1.01)).log2().abs() < 1.0 / 64.0,
        "{median}"
    );
}

/// A swapped lobe at one vertex, the last bit of one sample: each is named with its address.
#[test]
fn one_path_of_all_is_found() {
    if cpu_driver().is_none() {
        return;
    }
    let samples = table(1).expect("a device");
    let [before, _] = compared(&samples);
    assert!(before.is_equal(), "{before:?}");
    let lit = |s: &&PairedSample| s.f32.radiance[1] > 0.0;
    let victim = samples.iter().skip(7000).find(lit).expect("light").address;
    let planted = |plant: &dyn Fn(&mut PairedSample)| {
        let mut samples = samples.clone();
        let of_victim = samples.iter_mut().filter(|s| s.address == victim);
        of_victim.for_each(plant);
        let [pair, _] = compared(&samples);
        assert_eq!(
            (pair.paths - pair.equal, pair.first_unequal),
            (1, Some(victim))
        );
        pair
    };
    let bit = planted(&|s| s.device.radiance[1] = f64::from((s.f32.radiance[1] as f32).next_up()));
    assert_eq!((bit.together, bit.first_diverged), (bit.paths, None));
    assert_eq!(bit.closeness.worst.map(|w| w.address), Some(victim));
    let lobe = planted(&|s| s.device.signature ^= 1);
    assert_eq!(
        (lobe.paths - lobe.together, lobe.first_diverged),
        (1, Some(victim))
    );
}

/// A mistake in the weights or in the adjoint of both kernels: the device has another mean than cpu-f32 over the same samples,
/// on a device of any rounding. A t-test over sample indices, Šidák over the mistakes at α = 1e-3.
#[test]
fn mistakes_of_bidirectional_kernels_are_noticed() {
    let mistakes = [
        // A cosine that is forgotten.
        (
            "integrator/bidirectional/partial",
            "to.cosine * back / to.pdf",
            "back / to.pdf",
            TABLE,
        ),
        // dVCM lives on beyond a delta lobe.
        (
            "integrator/bidirectional/partial",
            "Partial(0.0, cosine * at.vc)",
            "Partial(at.vcm, cosine * at.vc)",
            SMOOTH,
        ),
        // A distance that is not squared.
        (
            "integrator/bidirectional/partial",
            "float square = distance * distance;",
            "float square = distance;",
            TABLE,
        ),
        // eta² on light paths, as on eye paths.
        (
            "bsdf/scaling/both",
            "from_light != RADIANCE_SCALING",
            "RADIANCE_SCALING",
            INSIDE,
        ),
    ];
    let level = sidak(1e-3, mistakes.len());
    for (name, right, wrong, scene) in mistakes {
        let honest = file(name).expect("a shader");
        assert_eq!(honest.matches(right).count(), 1, "{name}: {right}");
        let planted = honest.replace(right, wrong);
        for (text, noticed) in [(honest, false), (&planted, true)] {
            let files = [OwnFile { name, text }];
            let Some(differences) = differences(scene, &files) else {
                return;
            };
            let p = p_of_mean(&differences, 0.0, 0.0);
            println!("{wrong}: {noticed}, p = {p:.1e}");
            assert_eq!(p < level, noticed, "{wrong}: p = {p:.1e}");
        }
    }
}

/// How much more radiance the device gives than cpu-f32, sample index by sample index.
fn differences(scene: &str, files: &[OwnFile]) -> Option<Vec<f64>> {
    const SPP: u32 = 24;
    let settings = by(Integrator::Bidirectional);
    let prepared = prepared(scene, &settings);
    let job = Job {
        kernel: KernelChoice::Own(files),
        ..job(&prepared, settings, SPP, 1)
    };
    let mut sums = vec![0.0; SPP as usize];
    for s in samples(&job)? {
        sums[s.address.index as usize] += s.device.radiance[1] - s.f32.radiance[1];
    }
    Some(sums)
}
