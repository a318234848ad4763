//! The same paths by a device and by both references: the results of `compare --paired`, and that it finds planted errors.

mod planted;
mod scenes;
mod statistics;

use std::sync::atomic::AtomicBool;

use vkpt::metrics::paired::Comparison;
use vkpt::render::{Job, paired};
use vkpt::sample::PairedSample;

use crate::common;

/// Every sample of the job, three times; `None` if the run skips devices.
fn samples(job: &Job) -> Option<Vec<PairedSample>> {
    let mut all = Vec::new();
    let stop = AtomicBool::new(false);
    let device = common::device()?;
    let interrupted = paired(job, device, &stop, &mut |_| {}, &mut |s| all.push(*s));
    assert!(!interrupted.expect("a rendering"));
    Some(all)
}

/// The device compared with cpu-f32, and cpu-f32 with cpu-f64.
fn compared(samples: &[PairedSample]) -> [Comparison; 2] {
    let mut pairs: [Comparison; 2] = Default::default();
    for s in samples {
        pairs[0].add(s.address, &s.device, &s.f32);
        pairs[1].add(s.address, &s.f32, &s.f64);
    }
    pairs
}
