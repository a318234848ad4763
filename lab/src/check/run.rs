//! Runs cases one after the other and records the results.

use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::case::{Case, Expectation};
use super::judge::{ALPHA, Judge};
use super::measure::{CheckError, Measured, SEED, measure};
use crate::check::report::{CaseRecord, Check, Shown};
use vkpt::gpu::Device;
use vkpt::render::KernelChoice;
use vkpt::report::SettingsRecord;
use vkpt::sample::Address;

/// The device and options of a run.
pub struct Bench<'a> {
    pub device: &'a Device,
    /// Composed of vkpt's own files, except where a fault is planted.
    pub kernel: KernelChoice<'a>,
    pub quick: bool,
    /// The device must equal cpu-f32 in every bit, as CPU drivers must.
    pub correctly_rounded: bool,
    pub stop: &'a AtomicBool,
}

/// The results of a run.
pub struct Ran {
    pub record: Check,
    /// The page's data for each case in addition to the figures.
    pub shown: Vec<Shown>,
    /// Why the remaining cases did not run, other than a request to stop: a refused scene, or a device error.
    pub error: Option<CheckError>,
}

/// Runs `selected` of `all`, calling `progress` before each with the number of those done; cases with which one is
/// compared run with it. Levels are those of the whole battery, so that a verdict does not depend on the selection.
pub fn run(
    all: &[Case],
    selected: &[&Case],
    bench: &Bench,
    progress: &mut dyn FnMut(usize, &Case),
) -> Ran {
    let start = Instant::now();
    let info = bench.device.info();
    let judge = Judge::new(all.iter(), bench.correctly_rounded);
    let mut done: HashMap<&str, Measured> = HashMap::new();
    let (mut cases, mut shown, mut error) = (Vec::new(), Vec::new(), None);
    for (i, case) in selected.iter().enumerate() {
        progress(i, case);
        let measured = needed(all, case).into_iter().try_for_each(|needed| {
            if !done.contains_key(needed.name.as_str()) {
                let measured = measure(needed, bench.device, bench.kernel, bench.stop)?;
                done.insert(&needed.name, measured);
            }
            Ok(())
        });
        error = measured.err();
        if error.is_some() || bench.stop.load(Ordering::Relaxed) {
            break;
        }
        cases.push(record(case, &judge, &done));
        shown.push(show(case, &done[case.name.as_str()]));
    }
    let record = Check {
        version: env!("CARGO_PKG_VERSION"),
        device: info.name.clone(),
        driver: info.driver.clone(),
        correctly_rounded: bench.correctly_rounded,
        quick: bench.quick,
        level: judge.level,
        alpha: ALPHA,
        seconds: start.elapsed().as_secs_f64(),
        interrupted: cases.len() < selected.len(),
        passed: cases.iter().all(|c| c.passed),
        cases,
    };
    Ran {
        record,
        shown,
        error,
    }
}

/// A case, after those with which it is compared.
fn needed<'a>(all: &'a [Case], case: &'a Case) -> Vec<&'a Case> {
    let other = |e: &Expectation| match e {
        Expectation::SameMean { case, .. } | Expectation::SameBits { case, .. } => {
            all.iter().find(|c| c.name == *case)
        }
        _ => None,
    };
    case.expectations
        .iter()
        .filter_map(other)
        .chain([case])
        .collect()
}

fn record(case: &Case, judge: &Judge, done: &HashMap<&str, Measured>) -> CaseRecord {
    let m = &done[case.name.as_str()];
    let held = judge.held(case, m, &|name| done.get(name));
    let closeness = &m.f64.closeness;
    let at = |a: Address| [a.pixel[0], a.pixel[1], a.index];
    let mean = case.expectations.iter().find_map(|e| match e {
        Expectation::Mean { value, .. } => Some(*value),
        _ => None,
    });
    CaseRecord {
        name: case.name.clone(),
        about: case.about.clone(),
        samples: m.f64.paths,
        diverged: m.f64.paths - m.f64.together,
        median: closeness.quantile(0.5),
        p99: closeness.quantile(0.99),
        worst: closeness
            .worst
            .map(|w| w.difference)
            .or(closeness.quantile(1.0)),
        worst_at: closeness.worst.map(|w| at(w.address)),
        diverged_at: m.f64.first_diverged.map(at),
        nan: m.nan,
        infinite: m.infinite,
        largest: m.largest,
        mean: m.energy.mean,
        standard_error: m.energy.standard_error(),
        expected: mean,
        seconds: m.seconds,
        warnings: m.warnings.clone(),
        margin: held.iter().map(|h| h.margin).fold(0.0, f64::max),
        passed: held.iter().all(|h| h.passed()),
        held,
    }
}

fn show(case: &Case, m: &Measured) -> Shown {
    Shown {
        scene: case.text.clone(),
        triangles: case.mesh.as_ref().map(|mesh| mesh.triangles.len()),
        settings: SettingsRecord::from(&case.settings),
        spp: case.spp,
        seed: SEED,
        crop: case.crop,
        device: m.picture.device(),
        reference: m.picture.reference(),
        difference: m.picture.difference(),
    }
}
