//! Faults planted in the kernel: each must be found by the test made for it, as well as by the bits of a CPU driver.

use vkpt::film::Film;
use vkpt::kernel::{OwnFile, file};
use vkpt::metrics::difference_map;
use vkpt_lab::check::run::Ran;

use super::{fails_by, ran, ran_with_pictures};

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

/// The root of a negative number in the connection to lights: counted, on any device.
#[test]
fn a_nan_is_counted() {
    let name = "integrator/path/pick/candidate";
    let honest = file(name).expect("a shader");
    let text = honest.replace("(weight / p)", "sqrt(-1.0 - weight)");
    assert_ne!(text, honest);
    let files = [OwnFile { name, text: &text }];
    let Some(Ran { record, shown, .. }) = ran_with_pictures(&["light/tiny"], &files) else {
        return;
    };
    let case = &record.cases[0];
    assert_eq!(case.nan, case.samples, "{case:#?}");
    assert!(
        fails_by(&record, "light/tiny").contains(&"NaN"),
        "{case:#?}"
    );
    // And seen: no pixel has a number.
    let black = difference_map(16, 16, &[f64::NAN; 256]);
    assert_eq!(shown[0].difference, black);
}

/// The pictures are those of the samples that the record reports: of a crop far from the corner too, and of one pixel.
#[test]
fn pictures_have_the_means_of_the_record() {
    let names = [
        "camera/8192x8192",
        "camera/one-pixel",
        "camera/on-floor-level",
    ];
    let Some(Ran { record, shown, .. }) = ran_with_pictures(&names, &[]) else {
        return;
    };
    for ((case, shown), size) in record.cases.iter().zip(&shown).zip([8, 1, 16]) {
        for film in [&shown.device, &shown.reference, &shown.difference] {
            assert_eq!([film.width, film.height], [size; 2], "{}", case.name);
            assert_eq!(film.rgb.len(), (size * size) as usize, "{}", case.name);
        }
        let mean = |film: &Film| {
            let sum: f64 = film.rgb.iter().flatten().map(|&x| f64::from(x)).sum();
            sum / (3 * film.rgb.len()) as f64
        };
        // f32 keeps a mean to 2⁻²⁴; f64's result for the same paths is as near as all of them are.
        assert!(
            (mean(&shown.device) - case.mean).abs() < 1e-6,
            "{}",
            case.name
        );
        assert!(
            (mean(&shown.reference) - case.mean).abs() < 1e-5,
            "{}",
            case.name
        );
    }
    // The floor is black and fills the lower half.
    let rows = shown[2].device.rgb.chunks(16);
    for (y, row) in rows.enumerate() {
        assert!(row.iter().all(|p| (*p == [0.0; 3]) == (y >= 8)), "row {y}");
    }
}
