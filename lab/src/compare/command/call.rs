//! A comparison for a calling program, of pictures in files or in memory.

use super::comparand::Comparand;
use super::known::Known;
use super::pictures::compare;
use crate::cli::exit::Failure;
use crate::compare::report::Comparison;

/// The distance of `a` from `b`, its reference; FLIP brightens both by `exposure` stops.
pub fn compared(a: Comparand, b: Comparand, exposure: f64) -> Result<Comparison, Failure> {
    let [a, b] = [a, b].map(Known::new);
    compare(exposure, &[a?], &b?).map_err(Failure::Pictures)
}
