//! Faults planted in the kernel, each of which the comparison must find.

use vkpt::kernel::{OwnFile, file};
use vkpt::render::KernelChoice;
use vkpt::settings::{Connect, Settings};

use super::case::Case;
use super::furnace::brighter;
use super::interface::{Interface, excess};
use super::samples::{By, Made, made};
use super::sound::{broken, first_unequal};

/// Every sample of a lossless rough glass ball in a furnace, where `path` has `wrong` instead of `right`.
fn planted(path: &str, right: &str, wrong: &str) -> Option<Vec<Made>> {
    let honest = file(path).expect("a shader");
    assert_eq!(
        honest.matches(right).count(),
        1,
        "the place to be planted in"
    );
    let text = honest.replace(right, wrong);
    let files = [OwnFile {
        name: path,
        text: &text,
    }];
    let case = ball();
    made(
        By::All(KernelChoice::Own(&files)),
        &case,
        &case.prepared(),
        8,
    )
}

fn ball() -> Case {
    let mut settings = Settings::default();
    settings.estimator.connect = Connect::Bsdf;
    Case {
        text: "screen 4 4\ncamera 0 0 5  .15\nbackground 1 1 1\nfresnel exact\n\
               brdf 0 0 0  0 0 0  .01  1 1 1  1.5\nsphere 0 0 0  1\n"
            .to_owned(),
        settings,
        seed: 1,
    }
}

const SAMPLE: &str = "bsdf/sample";
const WEIGHT: &str = "value.value / value.pdf";

#[test]
fn a_sound_kernel_passes() {
    let case = ball();
    let composed = By::All(KernelChoice::Composed);
    let Some(all) = made(composed, &case, &case.prepared(), 8) else {
        return;
    };
    assert_eq!(
        (broken(&all, false), brighter(&all), first_unequal(&all)),
        (None, None, None)
    );
}

#[test]
fn a_nan_in_a_weight_is_found() {
    let nan = format!("{WEIGHT} * sqrt(0.5 - value.pdf)");
    let Some(all) = planted(SAMPLE, WEIGHT, &nan) else {
        return;
    };
    let found = broken(&all, false).expect("a finding");
    assert!(
        found.contains("the device") && found.contains("NaN"),
        "{found}"
    );
}

/// In one channel: a path whose throughput is nowhere above 0 ends.
#[test]
fn a_negative_weight_is_found() {
    let negative = format!("{WEIGHT} * vec3(1.0, -1.0, 1.0)");
    let Some(all) = planted(SAMPLE, WEIGHT, &negative) else {
        return;
    };
    let found = broken(&all, false).expect("a finding");
    assert!(
        found.contains("the device") && found.contains('-'),
        "{found}"
    );
}

#[test]
fn one_ulp_more_is_found() {
    let Some(all) = planted(SAMPLE, WEIGHT, &format!("({WEIGHT}) * 1.0000002")) else {
        return;
    };
    assert!(first_unequal(&all).is_some());
}

/// A fiftieth too much: the sample that is brighter than the world.
#[test]
fn an_albedo_too_large_is_found_in_a_furnace() {
    let Some(all) = planted(SAMPLE, WEIGHT, &format!("({WEIGHT}) * 1.02")) else {
        return;
    };
    let found = brighter(&all).expect("a finding");
    assert!(found.contains("the device"), "{found}");
}

/// 3 % too much, in the mean; light connections alone are too noisy for that.
#[test]
fn an_albedo_too_large_is_found_at_an_interface() {
    for connect in [Connect::Mis, Connect::Bsdf] {
        let mut settings = Settings::default();
        settings.estimator.connect = connect;
        let interface = Interface::of(true, 0.8, "brdf 0 0 0  1 1 1  .05  0 0 0  1", settings, 1);
        let prepared = interface.case.prepared();
        let limits = interface.limits(&prepared).expect("seen from outside");
        let mut all =
            made(By::References, &interface.case, &prepared, 128).expect("the references");
        let settings = &interface.case.settings;
        assert_eq!(excess(&limits, &all, settings, 1e-6), None);
        for made in &mut all {
            made.radiances
                .iter_mut()
                .for_each(|s| *s = s.map(|x| 1.03 * x));
        }
        assert!(
            excess(&limits, &all, settings, 1e-6).is_some(),
            "{connect:?}"
        );
    }
}
