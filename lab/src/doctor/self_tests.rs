//! Small kernels with known results, for features that a driver has got wrong or a path tracer relies on. The files of
//! `shaders/doctor/` record which driver failed how.

use super::bench::Bench;
use super::models;
use crate::doctor::report::{Outcome, SelfTest};
use vkpt::gpu::{BufferUse, GpuError};
use vkpt::layout::constants::workgroup::WORKGROUP;

/// A kernel and its results.
struct Test {
    name: &'static str,
    file: &'static str,
    /// Whether a rendering kernel does the same.
    relied_on: bool,
    /// Each reads the output of the last.
    dispatches: u32,
    result: fn(u32) -> u32,
    stands_for: &'static str,
}

/// A multiple of [`WORKGROUP`]; `shaders/doctor/hand_over.comp` and its model depend on it.
const INVOCATIONS: u32 = 1 << 16;
/// Rows of the uniform table: 16 KiB, which every device has to allow.
const TABLE: u32 = 1024;

const TESTS: [Test; 10] = [
    Test {
        name: "every invocation once",
        file: "doctor/invocations.comp",
        relied_on: true,
        dispatches: 1,
        result: models::invocations,
        stands_for: "each pixel's samples counted once",
    },
    Test {
        name: "loop with one exit",
        file: "doctor/loop_one_exit.comp",
        relied_on: true,
        dispatches: 1,
        result: models::lives,
        stands_for: "paths that end at different bounces",
    },
    Test {
        name: "loop left from within",
        file: "doctor/loop_restart.comp",
        relied_on: false,
        dispatches: 1,
        result: models::lives,
        stands_for: "a form that Mesa 22 has miscompiled",
    },
    Test {
        name: "break in an inner loop",
        file: "doctor/loop_break.comp",
        relied_on: true,
        dispatches: 1,
        result: models::collatz,
        stands_for: "searches that end early",
    },
    Test {
        name: "guards by if and ?:",
        file: "doctor/guard.comp",
        relied_on: true,
        dispatches: 1,
        result: models::guard,
        stands_for: "indices that are checked before use",
    },
    Test {
        name: "stack in a private array",
        file: "doctor/stack.comp",
        relied_on: true,
        dispatches: 1,
        result: models::stack,
        stands_for: "the traversal of a hierarchy",
    },
    Test {
        name: "uniform array, each lane's index",
        file: "doctor/table.comp",
        relied_on: true,
        dispatches: 1,
        result: models::table,
        stands_for: "materials, lights and shapes",
    },
    Test {
        name: "structs copied and inout",
        file: "doctor/structs.comp",
        relied_on: true,
        dispatches: 1,
        result: models::structs,
        stands_for: "a path's state",
    },
    Test {
        name: "dispatch after dispatch",
        file: "doctor/hand_over.comp",
        relied_on: true,
        dispatches: 3,
        result: models::hand_over,
        stands_for: "unfinished paths passed on",
    },
    Test {
        name: "barrier in a workgroup",
        file: "doctor/barrier.comp",
        relied_on: false,
        dispatches: 1,
        result: models::barrier,
        stands_for: "nothing yet: no kernel shares memory",
    },
];

/// All of them.
pub fn self_tests(bench: &Bench) -> Result<Vec<SelfTest>, GpuError> {
    TESTS.iter().map(|test| run(bench, test)).collect()
}

fn run(bench: &Bench, test: &Test) -> Result<SelfTest, GpuError> {
    use BufferUse::{Storage, Uniform};
    let device = bench.device;
    let kernel = match test.relied_on {
        true => bench.file(test.file)?,
        false => bench.unaudited_file(test.file)?,
    };
    let pipeline = device.pipeline(&kernel, &[Uniform, Storage, Storage], 0)?;
    let table = device.buffer("table", Uniform, 16 * u64::from(TABLE))?;
    let rows: Vec<[u32; 4]> = (0..TABLE).map(models::row).collect();
    table.write(bytemuck::cast_slice(&rows))?;
    let bytes = 4 * u64::from(INVOCATIONS);
    let buffers = [
        device.buffer("given", Storage, bytes)?,
        device.buffer("results", Storage, bytes)?,
    ];
    let mut words: Vec<u32> = (0..INVOCATIONS).collect();
    for buffer in &buffers {
        buffer.write(bytemuck::cast_slice(&words))?;
    }
    let [mut given, mut results] = [&buffers[0], &buffers[1]];
    for _ in 0..test.dispatches {
        device.dispatch(
            &pipeline,
            &[&table, given, results],
            &[],
            [INVOCATIONS / WORKGROUP, 1, 1],
        )?;
        std::mem::swap(&mut given, &mut results);
    }
    given.read_into(bytemuck::cast_slice_mut(&mut words))?;
    let wrong = (0..)
        .zip(&words)
        .filter(|(i, word)| (test.result)(*i) != **word)
        .count() as u32;
    let outcome = match (wrong, test.relied_on) {
        (0, _) => Outcome::Passes,
        (_, true) => Outcome::Fails,
        (_, false) => Outcome::Avoided,
    };
    Ok(SelfTest {
        name: test.name,
        outcome,
        invocations: INVOCATIONS,
        wrong,
        stands_for: test.stands_for,
    })
}
