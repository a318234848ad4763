//! `vkpt doctor` on the device of the tests, and with mistakes planted in its kernels.

use vkpt::gpu::{Device, DeviceKind};
use vkpt::kernel::{OwnFile, file};
use vkpt_lab::doctor::Examiner;
use vkpt_lab::doctor::report::{Examination, Outcome, page};

use crate::common;

fn examine(device: &Device, own: &[OwnFile]) -> Examination {
    let exhaustive = false;
    Examiner { exhaustive, own }
        .examine(device)
        .expect("an examination")
}

/// The file's text with `from` replaced, which it must hold.
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
    let found = examine(device, &[]);
    let page = page(&found);
    assert!(found.verdict.healthy, "{page}");
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

/// Vulkan's bounds are wide: whatever keeps to them, and lavapipe does, is told so.
#[test]
fn the_drivers_functions_are_measured_and_judged_by_vulkans_bounds() {
    let Some(device) = common::device() else {
        return;
    };
    let found = examine(device, &[]);
    for f in &found.driver_functions {
        // Nothing but a correctly rounded function is 0.5 ulp off; nothing at all is less, over so many arguments.
        assert!(f.ulps.error > 0.49, "{f:?}");
        assert!(f.relative.error > 0.0 && f.absolute.error > 0.0, "{f:?}");
    }
    let sine = &found.driver_functions[0];
    assert_eq!(
        sine.within,
        Some(sine.absolute.error <= 2f64.powi(-11)),
        "{sine:?}"
    );
    if !device.info().name.contains("llvmpipe") {
        return;
    }
    // lavapipe has pow as exp2(y·log2 x): rounding y·log2(x), which goes to 117, alone makes it wrong by ½·2⁻¹⁷ ln 2.
    let power = found
        .driver_functions
        .iter()
        .find(|f| f.name.starts_with("pow"));
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
