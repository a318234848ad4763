//! Joining the parts, one file after the other: while one is joined, the next is read; no others are in memory.

use std::path::Path;
use std::sync::mpsc::sync_channel;
use std::thread;

use super::order::InOrder;
use crate::render::error_of;
use vkpt::part::{AnyPart, Misfit};
use vkpt::render::{ErrorAt, look};
use vkpt::state::{self, Header, Kept, StateError};
use vkpt_lab::cli::exit::Failure;

/// The joined parts.
pub struct Joined {
    pub part: AnyPart,
    /// After the numbers of samples at which one rendering estimates its error.
    pub errors: Vec<ErrorAt>,
}

/// Reads and joins all parts.
///
/// # Errors
/// If a file is damaged, or was changed since its header was read.
pub fn join(parts: &InOrder) -> Result<Joined, Failure> {
    thread::scope(|scope| {
        let (send, read) = sync_channel::<Result<Kept, StateError>>(0);
        scope.spawn(move || {
            // The receiver stops at the first error.
            let mut all = parts.paths().map(state::read);
            all.all(|kept| send.send(kept).is_ok())
        });
        let mut joined: Option<Joined> = None;
        let mut seconds = 0.0;
        for ((path, header), kept) in parts.paths().zip(parts.headers()).zip(read) {
            let Kept { part, .. } = kept.map_err(|error| wrong(path, error))?;
            seconds += header.record.seconds.render;
            match &mut joined {
                None => {
                    let errors = header.record.error.iter().map(error_of).collect();
                    joined = Some(Joined { part, errors });
                }
                Some(whole) => {
                    let last = parts.samples().len() as u32;
                    let added = whole.append(part, header, last, seconds);
                    added.map_err(|misfit| wrong(path, misfit))?;
                }
            }
        }
        joined.ok_or_else(|| Failure::Usage("no parts given".to_owned()))
    })
}

fn wrong(path: &Path, why: impl std::fmt::Display) -> Failure {
    Failure::Pictures(vec![format!("{}: {why}", path.display())])
}

impl Joined {
    /// Adds the next part, and estimates the error after powers of two and after `last` samples; `seconds` are those of all
    /// parts so far.
    fn append(
        &mut self,
        next: AnyPart,
        header: &Header,
        last: u32,
        seconds: f64,
    ) -> Result<(), Misfit> {
        let [x0, y0, ..] = header.record.job.crop.unwrap_or_default();
        let errors = &mut self.errors;
        self.part.append(next, &mut |spp, halves| {
            if spp.is_power_of_two() || spp == last {
                look(errors, spp, seconds, [x0, y0], halves);
            }
        })
    }
}
