//! Omission changes no bit: a kernel that contains more than its scene needs, one member or all, makes the
//! same picture on a CPU driver; one that lacks a needed member makes another. Every combination compiles.

mod bits;
mod combinations;
mod members;
mod scenes;

use std::collections::BTreeSet;

use vkpt::features::{Features, Member};
use vkpt::render::Job;

/// All there is.
fn full(job: &Job) -> Features {
    Features::full(&job.settings, job.aovs)
}

/// Every member that the composed kernel of a job does not contain.
fn extra(job: &Job) -> BTreeSet<Member> {
    let all = full(job).members();
    all.difference(&job.features().members()).copied().collect()
}
