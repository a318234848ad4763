//! The cost of a call of vkpt's own functions, and of the driver's equivalent.

use std::time::Duration;

use super::bench::{Bench, Subject};
use crate::doctor::report::Cost;
use vkpt::gpu::{Buffer, BufferUse, GpuError, Pipeline};
use vkpt::kernel::unaudited::Arithmetic;
use vkpt::layout::constants::workgroup::WORKGROUP;

const INVOCATIONS: u32 = 1 << 16;
/// Calls per invocation, as in `shaders/doctor/cost.comp`.
const CALLS: u32 = 64;
/// Rounds, each of which runs everything once.
const ROUNDS: usize = 9;

/// Name, file and expression of ours; name and expression of theirs.
const PAIRS: [[&str; 5]; 4] = [
    [
        "sincos_2pi",
        "math/elementary/sincos",
        "dot(sincos_2pi(x), vec2(1.0, 1.0))",
        "sin, cos",
        "sin(x * 6.2831855) + cos(x * 6.2831855)",
    ],
    ["exp", "math/elementary/exp", "exp(x)", "exp", "exp(x)"],
    [
        "expm1",
        "math/elementary/expm1",
        "expm1(x)",
        "exp(x) − 1",
        "exp(x) - 1.0",
    ],
    [
        "log1p",
        "math/elementary/log1p",
        "log1p(x)",
        "log(1 + x)",
        "log(1.0 + x)",
    ],
];

/// Alternating, by the device's clock if it has one; minus the loop around the calls.
pub fn costs(bench: &Bench) -> Result<Vec<Cost>, GpuError> {
    let storage = BufferUse::Storage;
    let results = bench
        .device
        .buffer("results", storage, 4 * u64::from(INVOCATIONS))?;
    let pipeline = |subject: Subject| {
        let kernel = bench.with("doctor/cost.comp", &subject)?;
        bench.device.pipeline(&kernel, &[storage], 0)
    };
    let mut pipelines = vec![pipeline(Subject::float("", "x"))?];
    for [_, file, own, _, theirs] in PAIRS {
        for subject in [Subject::float(file, own), Subject::float("", theirs)] {
            pipelines.push(pipeline(subject.unaudited(Arithmetic::AsWritten))?);
        }
    }
    let seconds = quickest(bench, &pipelines, &results)?;
    let calls = f64::from(INVOCATIONS * CALLS);
    let nanoseconds = |k: usize| 1e9 * (seconds[k] - seconds[0]).max(0.0) / calls;
    let cost = |(k, [name, _, _, drivers_name, _]): (usize, [&'static str; 5])| Cost {
        name,
        drivers_name,
        own: nanoseconds(2 * k + 1),
        drivers: nanoseconds(2 * k + 2),
    };
    Ok(PAIRS.into_iter().enumerate().map(cost).collect())
}

/// Seconds of each, the quickest round: other load on the machine only adds time, and on lavapipe a lot. Excludes the
/// first round, in which drivers compile.
fn quickest(bench: &Bench, pipelines: &[Pipeline], results: &Buffer) -> Result<Vec<f64>, GpuError> {
    let groups = [INVOCATIONS / WORKGROUP, 1, 1];
    let run = |p: &Pipeline| bench.device.dispatch(p, &[results], &[], groups);
    let mut times = vec![Duration::MAX; pipelines.len()];
    for round in 0..=ROUNDS {
        for (pipeline, quickest) in pipelines.iter().zip(&mut times) {
            let time = run(pipeline)?;
            if round > 0 {
                *quickest = time.min(*quickest);
            }
        }
    }
    Ok(times.iter().map(Duration::as_secs_f64).collect())
}
