//! `vkpt doctor` on the device of the tests, and with mistakes planted in its kernels.

use std::sync::atomic::AtomicBool;

use vkpt::gpu::{Device, DeviceKind};
use vkpt::kernel::{OwnFile, file};
use vkpt::render::KernelChoice;
use vkpt_lab::check::select::SHORT;
use vkpt_lab::doctor::Examiner;
use vkpt_lab::doctor::report::{Examination, Outcome, page};

use crate::common;

static NEVER: AtomicBool = AtomicBool::new(false);

/// What decides, without the battery.
const PROBES: Examiner = Examiner {
    exhaustive: false,
    all: false,
    cases: &[],
    own: &[],
    kernel: KernelChoice::Composed,
    stop: &NEVER,
};

fn examined(examiner: Examiner, device: &Device) -> Examination {
    examiner
        .examine(device, &mut |_, _| {})
        .expect("an examination")
}

fn examine(device: &Device, own: &[OwnFile]) -> Examination {
    examined(Examiner { own, ..PROBES }, device)
}

/// The file's text with `from` replaced, which it must contain.
fn altered(name: &str, from: &str, to: &str) -> String {
    let text = file(name).expect("a file of shaders/");
    assert!(text.contains(from), "{name} has no {from}");
    text.replace(from, to)
}

#[test]
fn the_device_of_the_tests_is_healthy() {
    let Some(device) = common::device() else {
        return;
    };
    let mut pieces = Vec::new();
    let short = Examiner {
        cases: &SHORT,
        ..PROBES
    };
    let found = short.examine(device, &mut |done, name| {
        pieces.push((done, name.to_owned()))
    });
    let found = found.expect("an examination");
    let page = page(&found);
    assert!(found.verdict.healthy, "{page}");
    assert_eq!(found.battery.check.cases.len(), SHORT.len());
    assert_eq!(
        found.battery.check.correctly_rounded,
        found.verdict.equal_bits
    );
    assert!(pieces.is_sorted_by(|a, b| a.0 < b.0), "{pieces:?}");
    let last = format!("case {0} of {0}: {1}", SHORT.len(), SHORT[SHORT.len() - 1]);
    assert_eq!(pieces.last().map(|(_, name)| name), Some(&last));
    for words in ["Nanoseconds", "GLSL", "by algebra"] {
        assert!(!page.contains(words), "{words}: {page}");
    }
    // CPU drivers round correctly; a GPU may divide otherwise.
    if device.info().kind == DeviceKind::Cpu {
        let own = found.own_functions.iter();
        assert!(own.clone().all(|f| f.unequal == 0), "{page}");
        assert!(own.clone().all(|f| f.worst_ulps <= f.bound_ulps), "{page}");
    }
    for line in page.lines() {
        assert!(line.chars().count() <= 100, "{line}");
        assert_eq!(line, line.trim_end());
    }
    assert!(page.lines().next().is_some_and(|l| l.contains("healthy")));
    assert_eq!(device.validation_messages(), Vec::<String>::new());
}

/// Vulkan's bounds are wide: a device that keeps them, as lavapipe does, is reported to.
#[test]
fn the_drivers_functions_are_measured_and_judged_by_vulkans_bounds() {
    let Some(device) = common::device() else {
        return;
    };
    let all = Examiner {
        all: true,
        ..PROBES
    };
    let found = examined(all, device);
    let page = page(&found);
    for words in ["Nanoseconds", "GLSL", "fma"] {
        assert!(page.contains(words), "{words}: {page}");
    }
    let functions = found.driver_functions.expect("they were examined");
    for f in &functions {
        // Only a correctly rounded function is 0.5 ulp off; none is less, over so many arguments.
        assert!(f.ulps.error > 0.49, "{f:?}");
        assert!(f.relative.error > 0.0 && f.absolute.error > 0.0, "{f:?}");
    }
    let sine = &functions[0];
    assert_eq!(
        sine.within,
        Some(sine.absolute.error <= 2f64.powi(-11)),
        "{sine:?}"
    );
    if !device.info().name.contains("llvmpipe") {
        return;
    }
    // lavapipe has pow as exp2(y·log2 x): rounding y·log2(x), which goes to 117, alone makes it wrong by ½·2⁻¹⁷ ln 2.
    let power = functions.iter().find(|f| f.name.starts_with("pow"));
    assert!(power.is_some_and(|p| p.relative.error > 2f64.powi(-20)));
}

#[test]
fn a_wrong_digit_in_an_own_function_is_found() {
    let Some(device) = common::device() else {
        return;
    };
    // One unit of the last place of the coefficient of x², about 6e-8 of its share in the result.
    let text = altered(
        "math/elementary/exp",
        "0.16666666 + r * e",
        "0.1666667 + r * e",
    );
    let name = "math/elementary/exp";
    let found = examine(device, &[OwnFile { name, text: &text }]);
    let exp = found.own_functions.iter().find(|f| f.name == "exp");
    let exp = exp.expect("exp was examined");
    assert!(exp.unequal > 0, "{exp:?}");
    // A device that rounds correctly has no excuse.
    if found
        .operations
        .iter()
        .all(|o| o.outcome == Outcome::Passes)
    {
        assert_eq!(exp.outcome, Outcome::Fails);
        assert!(!found.verdict.healthy);
        assert!(page(&found).contains("NOT HEALTHY"));
    }
    let others = found
        .own_functions
        .iter()
        .filter(|f| f.name.starts_with("sincos"));
    assert!(others.clone().count() == 2 && others.clone().all(|f| f.outcome != Outcome::Fails));
}

/// A mistake in each kernel of the self-tests, such as a driver's compiler might make.
#[test]
fn every_self_test_fails_on_its_mistake() {
    let Some(device) = common::device() else {
        return;
    };
    let mistakes = [
        ("doctor/invocations.comp", "* 31u + i", "* 31u * 31u + i"),
        ("doctor/loop_one_exit.comp", "lives < 16u", "lives < 15u"),
        ("doctor/loop_restart.comp", "age == 40u", "age == 41u"),
        ("doctor/loop_break.comp", "== 37u", "== 38u"),
        (
            "doctor/guard.comp",
            "if (at <= i)",
            "calls += 1u; if (at <= i)",
        ),
        (
            "doctor/stack.comp",
            "top -= 1u;",
            "top -= 1u; stack[0] = 0u;",
        ),
        ("doctor/table.comp", "rows[at.z]", "rows[at.y]"),
        ("doctor/structs.comp", "inout Path", "in Path"),
        (
            "doctor/hand_over.comp",
            "given.words[from]",
            "given.words[i]",
        ),
        (
            "doctor/barrier.comp",
            "uint half_of = WORKGROUP / 2u",
            "uint half_of = WORKGROUP / 4u",
        ),
    ];
    let texts = mistakes.map(|(name, from, to)| altered(name, from, to));
    let own: Vec<OwnFile> = mistakes
        .iter()
        .zip(&texts)
        .map(|((name, ..), text)| OwnFile { name, text })
        .collect();
    let found = examine(device, &own);
    assert_eq!(found.self_tests.len(), mistakes.len());
    for test in &found.self_tests {
        assert!(test.wrong > 0, "{test:?}");
        assert!(matches!(test.outcome, Outcome::Fails | Outcome::Avoided));
    }
    let avoided = found
        .self_tests
        .iter()
        .filter(|t| t.outcome == Outcome::Avoided);
    assert_eq!(avoided.count(), 2);
    assert_eq!(found.verdict.failures.len(), 8, "{:?}", found.verdict);
}

/// Floats that do not arrive as they were.
#[test]
fn moved_bits_that_change_are_found() {
    let Some(device) = common::device() else {
        return;
    };
    let text = altered(
        "doctor/move.comp",
        "(i & 1u) == 0u ? a : b",
        "((i & 1u) == 0u ? a : b) * 1.5",
    );
    let name = "doctor/move.comp";
    let found = examine(device, &[OwnFile { name, text: &text }]);
    let moved = found.operations.iter().find(|o| o.name.contains("moved"));
    assert!(moved.is_some_and(|o| o.outcome == Outcome::Fails && o.example.is_some()));
    assert!(!found.verdict.healthy);
}

/// Twice the reflectance: all arithmetic is right, and a picture is wrong.
#[test]
fn a_case_of_the_battery_that_fails_is_named() {
    let Some(device) = common::device() else {
        return;
    };
    let name = "bsdf/fresnel/exact";
    let text = altered(
        name,
        "min2(0.5 * a * a * (1.0 + b * b), 1.0)",
        "min2(a * a * (1.0 + b * b), 1.0)",
    );
    let files = [OwnFile { name, text: &text }];
    let planted = Examiner {
        cases: &["light/in-glass"],
        kernel: KernelChoice::Own(&files),
        ..PROBES
    };
    let found = examined(planted, device);
    let verdict = &found.verdict;
    assert!(
        !verdict.healthy && !verdict.equal_bits && !verdict.interrupted,
        "{verdict:?}"
    );
    let [failure] = &verdict.failures[..] else {
        panic!("{verdict:?}");
    };
    let next = format!(
        "next: vkpt check --device {} --case light/in-glass",
        device.info().index
    );
    assert!(
        failure.contains("case light/in-glass: ") && failure.contains("energy "),
        "{failure}"
    );
    assert!(failure.ends_with(&next), "{failure}");
    let page = page(&found);
    assert!(page.contains("NOT HEALTHY"), "{page}");
    let row = page.lines().find(|l| l.starts_with("  light/in-glass"));
    assert!(row.is_some_and(|row| row.contains("FAILS")), "{page}");
}

/// A kernel that cannot be made, as by a device that is lost: a file that no kernel contains.
#[test]
fn a_battery_that_cannot_be_rendered_fails() {
    let Some(device) = common::device() else {
        return;
    };
    let (name, text) = ("doctor/move.comp", "");
    let planted = Examiner {
        cases: &["light/tiny", "light/none"],
        kernel: KernelChoice::Own(&[OwnFile { name, text }]),
        ..PROBES
    };
    let found = examined(planted, device);
    assert!(found.battery.check.cases.is_empty());
    assert!(found.battery.error.is_some());
    let verdict = found.verdict;
    assert!(!verdict.healthy && !verdict.interrupted, "{verdict:?}");
    assert!(verdict.failures[0].contains("light/tiny"), "{verdict:?}");
}

#[test]
fn an_examination_that_is_stopped_is_no_verdict() {
    let Some(device) = common::device() else {
        return;
    };
    let stopped = Examiner {
        exhaustive: true,
        cases: &["light/tiny"],
        stop: &AtomicBool::new(true),
        ..PROBES
    };
    let found = examined(stopped, device);
    assert!(found.own_functions.is_empty() && found.battery.check.cases.is_empty());
    assert!(found.verdict.interrupted && !found.verdict.healthy);
    let page = page(&found);
    let first = page.lines().next().unwrap_or_default();
    assert!(first.contains(": interrupted: "), "{page}");
}
