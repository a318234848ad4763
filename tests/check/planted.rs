//! Faults planted in the kernel: each must be found by what is there to find it, beside the bits of a CPU driver.

use vkpt::kernel::{OwnFile, file};

use crate::{fails_by, ran};

const FRESNEL: &str = "bsdf/fresnel/exact";
const LINE: &str = "    float f = min2(0.5 * a * a * (1.0 + b * b), 1.0);";

/// Fresnel's equations with another last line.
fn fresnel(line: &str) -> String {
    let text = file(FRESNEL).expect("a shader");
    assert_eq!(text.matches(LINE).count(), 1, "the line to be planted in");
    text.replace(LINE, line)
}

/// Twice the reflectance loses nothing in a furnace; a light in glass is darker by it.
#[test]
fn a_wrong_reflectance_fails_the_closed_form() {
    let text = fresnel("    float f = min2(a * a * (1.0 + b * b), 1.0);");
    let files = [OwnFile {
        name: FRESNEL,
        text: &text,
    }];
    let Some(check) = ran(&["light/in-glass"], &files) else {
        return;
    };
    assert!(
        fails_by(&check, "light/in-glass").contains(&"energy"),
        "{check:#?}"
    );
    assert!(!check.passed);
}

/// The root of a negative number in the connection to lights: counted, on whatever device.
#[test]
fn a_nan_is_counted() {
    let name = "path/direct/sample";
    let honest = file(name).expect("a shader");
    let text = honest.replace("(weight / p)", "sqrt(-1.0 - weight)");
    assert_ne!(text, honest);
    let files = [OwnFile { name, text: &text }];
    let Some(check) = ran(&["light/tiny"], &files) else {
        return;
    };
    let case = &check.cases[0];
    assert_eq!(case.nan, case.samples, "{case:#?}");
    assert!(fails_by(&check, "light/tiny").contains(&"NaN"), "{case:#?}");
}
