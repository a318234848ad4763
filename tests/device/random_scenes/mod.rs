//! Random scenes: materials and settings over the whole legal range, shapes that touch, nest and overlap. In all of
//! them, no path contributes a NaN, an infinity or less than 0, and no surface returns more light than it may.
//!
//! Cases are the same in every run. A case that fails is shrunk and printed as a scene file; its seed goes to
//! `regressions.txt`, which is tried first ever after, and the scene becomes a test by name in `found.rs`.

mod bound;
mod case;
mod found;
mod furnace;
mod interface;
mod material;
mod number;
mod planted;
mod samples;
mod settings;
mod shape;
mod sound;

use std::fmt::Debug;

use proptest::prelude::*;
use proptest::test_runner::{FileFailurePersistence, RngSeed, TestCaseResult, TestRunner};

/// Tries `cases` of a property, from a seed; those that failed once, in `file`, come first.
fn check_property<S>(
    file: &'static str,
    cases: u32,
    seed: u64,
    strategy: S,
    property: impl Fn(&S::Value) -> TestCaseResult,
) where
    S: Strategy,
    S::Value: Debug,
{
    let config = ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(file))),
        max_shrink_iters: 10_000,
        ..ProptestConfig::default()
    };
    let tried = TestRunner::new(config).run(&strategy, |case| property(&case));
    tried.unwrap_or_else(|e| panic!("seed {seed}: {e}"));
}

/// Seeds of the long runs: `VKPT_TEST_SEEDS=20..30`, or ten of them.
fn long_seeds() -> std::ops::Range<u64> {
    let given = std::env::var("VKPT_TEST_SEEDS").ok();
    let range = given.as_deref().and_then(|text| {
        let (first, end) = text.split_once("..")?;
        Some(first.parse().ok()?..end.parse().ok()?)
    });
    range.unwrap_or(1000..1010)
}
