//! Joining the parts, one file after the other: one of them is in memory beside what they make.

use super::order::InOrder;
use crate::cli::exit::Failure;
use crate::cli::render::error_of;
use crate::part::AnyPart;
use crate::render::{ErrorAt, look};
use crate::state::{self, Kept};

/// What the parts make.
pub struct Joined {
    pub part: AnyPart,
    /// After as many samples as one rendering looks at its error.
    pub errors: Vec<ErrorAt>,
}

/// Reads and joins all parts.
///
/// # Errors
/// Of a file that is damaged, or was changed since its header was read.
pub fn join(parts: &InOrder) -> Result<Joined, Failure> {
    let mut joined: Option<Joined> = None;
    let mut seconds = 0.0;
    for (path, header) in parts.paths().zip(parts.headers()) {
        let wrong = |error: String| Failure::Pictures(vec![format!("{}: {error}", path.display())]);
        let Kept { part, .. } = state::read(path).map_err(|error| wrong(error.to_string()))?;
        seconds += header.record.seconds.render;
        match &mut joined {
            None => {
                let errors = header.record.error.iter().map(error_of).collect();
                joined = Some(Joined { part, errors });
            }
            Some(Joined {
                part: whole,
                errors,
            }) => {
                let [x0, y0, ..] = header.record.job.crop.unwrap_or_default();
                let last = parts.samples().len() as u32;
                let mut see = |spp: u32, halves: &dyn Fn() -> _| {
                    if spp.is_power_of_two() || spp == last {
                        look(errors, spp, seconds, [x0, y0], halves);
                    }
                };
                let added = whole.append(part, &mut see);
                added.map_err(|misfit| wrong(misfit.to_string()))?;
            }
        }
    }
    joined.ok_or_else(|| Failure::Usage("there are no parts".to_owned()))
}
