//! The record of merged parts: that of one rendering, with the seconds of all parts.

use super::join::Joined;
use super::order::InOrder;
use crate::render::{dropped, error, largest};
use vkpt::film::Film;
use vkpt::memory::peak;
use vkpt::report::{Job, Machine, Memory, Record, Seconds, Work};

pub fn record(parts: &InOrder, joined: &Joined, film: &Film) -> Record {
    let first = &parts.first().record;
    let all: Vec<&Record> = parts.headers().map(|header| &header.record).collect();
    let seconds = all
        .iter()
        .fold(Seconds::default(), |s, r| plus(s, r.seconds));
    let samples = parts.samples();
    let tally = joined.part.tally();
    let pixels = u64::from(film.width) * u64::from(film.height);
    let counts = tally.counts;
    Record {
        version: first.version.clone(),
        job: Job {
            range: (samples.start > 0).then_some([samples.start, samples.end]),
            spp: samples.len() as u32,
            spp_asked: samples.len() as u32,
            ended: "complete".into(),
            time: None,
            target_error: None,
            ..first.job.clone()
        },
        machine: Machine {
            device: distinct(all.iter().map(|r| &r.machine.device)).join(", "),
            driver: distinct(all.iter().map(|r| &r.machine.driver)).join(", "),
            memory: Memory {
                peak: peak(),
                ..first.machine.memory
            },
            ..first.machine.clone()
        },
        seconds,
        work: Work::new(
            &seconds,
            u64::from(joined.part.samples()) * pixels,
            counts.rays,
            dropped(counts.dropped),
            counts.long_paths,
            counts.underflows,
        ),
        largest: largest(film, tally.largest),
        error: joined.errors.iter().map(error).collect(),
        files: Vec::new(),
        denoised: None,
        warnings: distinct(all.iter().flat_map(|r| &r.warnings)),
    }
}

fn plus(a: Seconds, b: Seconds) -> Seconds {
    Seconds {
        read: a.read + b.read,
        prepare: a.prepare + b.prepare,
        device: a.device + b.device,
        hierarchy: a.hierarchy + b.hierarchy,
        compose: a.compose + b.compose,
        upload: a.upload + b.upload,
        pipeline: a.pipeline + b.pipeline,
        compile: a.compile + b.compile,
        render: a.render + b.render,
        gpu: a.gpu.zip(b.gpu).map(|(a, b)| a + b).or(a.gpu).or(b.gpu),
        write: a.write + b.write,
    }
}

/// Each once, in their order.
fn distinct<'a>(all: impl Iterator<Item = &'a String>) -> Vec<String> {
    let mut distinct: Vec<String> = Vec::new();
    for one in all {
        if !distinct.contains(one) {
            distinct.push(one.clone());
        }
    }
    distinct
}
