//! Standard errors from a file.

use std::path::Path;

use super::exit::warn;
use vkpt::image::{Picture, Precision};
use vkpt::metrics::StandardErrors;
use vkpt::report::{Difference, differences, digest, is_noted, noted_digest, noted_freedom};

/// The standard errors of a file, with the degrees of freedom that it notes; those of other programs are taken as exact.
pub fn standard_errors(picture: &Picture) -> StandardErrors<'_> {
    StandardErrors {
        film: &picture.film,
        freedom: noted_freedom(&picture.notes).unwrap_or(f64::INFINITY),
    }
}

/// Refuses standard errors of another picture, according to the notes of both files; `advice` names another remedy.
///
/// Files of other programs have no notes. If only the picture lacks them, a warning is printed.
pub fn belongs(
    (errors, theirs): (&Path, &Picture),
    (picture, its): (&Path, &Picture),
    advice: &str,
) -> Result<(), String> {
    let (errors, picture) = (errors.display().to_string(), picture.display().to_string());
    let between = |each: Difference| each.between([&errors, &picture]);
    let differences = differences(&theirs.notes, &its.notes);
    let mut differences =
        differences.map(|all| all.into_iter().map(between).collect::<Vec<String>>());
    // Other formats round: their values do not match the digest.
    let exact = its.precision == Precision::Single;
    if let Some(theirs) = noted_digest(&theirs.notes).filter(|_| exact) {
        let all = differences.get_or_insert_default();
        if all.is_empty() && theirs != digest(&its.film) {
            all.push("it was made with a picture of other values, perhaps from another version of the scene".into());
        }
    }
    match differences.as_deref() {
        Some([]) => {}
        Some(all) => {
            let all = all.join(", ");
            return Err(format!(
                "{errors} does not belong to {picture}: {all}; render again with --aov stderr, or {advice}"
            ));
        }
        None if is_noted(&theirs.notes) => warn(&format!(
            "{picture} does not record how it was made: cannot check whether {errors} belongs to it"
        )),
        None => {}
    }
    Ok(())
}
