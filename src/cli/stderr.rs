//! Standard errors from a file.

use crate::image::Picture;
use crate::metrics::StandardErrors;
use crate::report::noted_freedom;

/// The standard errors of a file, with the degrees of freedom that it notes; those of other programs are taken for exact.
pub fn standard_errors(picture: &Picture) -> StandardErrors<'_> {
    StandardErrors {
        film: &picture.film,
        freedom: noted_freedom(&picture.notes).unwrap_or(f64::INFINITY),
    }
}
