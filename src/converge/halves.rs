//! A reference of one's own: the scene twice, by independent random numbers.

use std::sync::atomic::AtomicBool;

use super::ConvergeError;
use crate::film::Film;
use crate::render::{Engine, Job, Progress, Replicates};

/// The seeds of the halves. No replicate may have them.
pub const HALVES: [u32; 2] = [u32::MAX - 1, u32::MAX];

/// Two pictures of the same scene with as many samples each.
#[derive(Clone, Debug, PartialEq)]
pub struct Halves {
    pub films: [Film; 2],
    /// Samples per pixel of each.
    pub spp: u64,
    /// What both took.
    pub seconds: f64,
}

/// Renders both halves by turns until they took `seconds` together, with `spp` samples each at most; `None` if `stop`
/// came first. The job's seed and samples are not looked at.
///
/// # Errors
/// Those of a rendering.
pub fn halves(
    job: &Job,
    engine: &Engine,
    (seconds, most): (f64, u64),
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Option<Halves>, ConvergeError> {
    let mut replicates = Replicates::new(job, engine, &HALVES)?;
    let (mut spent, mut spp) = (0.0, 1);
    loop {
        for i in 0..HALVES.len() {
            spent += replicates.advance(i, spp, stop)?.wall_s;
            if replicates.done(i) < spp {
                return Ok(None);
            }
        }
        progress(Progress {
            samples_done: spp,
            spp,
            fraction: (spent / seconds).min(1.0),
        });
        // What fits into the time that is left, at the pace so far; twice as much at most, for a better look at the pace.
        let fits = spp as f64 * (seconds / spent).min(2.0);
        let next = (fits as u64).min(most);
        if next <= spp {
            return Ok(Some(Halves {
                films: [0, 1].map(|i| replicates.picture(i)),
                spp,
                seconds: spent,
            }));
        }
        spp = next;
    }
}
