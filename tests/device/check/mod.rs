//! `vkpt check`: its battery is sound, and mistakes planted in a kernel fail it.

mod battery;
mod closed;
mod page;
mod planted;

use std::sync::atomic::AtomicBool;

use vkpt::gpu::DeviceKind;
use vkpt::kernel::OwnFile;
use vkpt::render::KernelChoice;
use vkpt_lab::check::report::Check;
use vkpt_lab::check::run::{Bench, Ran, run};
use vkpt_lab::check::{Case, battery};

use crate::common;

/// The named cases, by a kernel with its own `files`; `None` if the run skips devices.
fn ran(names: &[&str], files: &[OwnFile]) -> Option<Check> {
    Some(ran_with_pictures(names, files)?.record)
}

/// The same, with the pictures.
fn ran_with_pictures(names: &[&str], files: &[OwnFile]) -> Option<Ran> {
    let device = common::device()?;
    let all = battery();
    let find = |name: &&str| {
        all.iter()
            .find(|c| c.name == **name)
            .unwrap_or_else(|| panic!("no case {name}"))
    };
    let selected: Vec<&Case> = names.iter().map(find).collect();
    let kernel = if files.is_empty() {
        KernelChoice::Composed
    } else {
        KernelChoice::Own(files)
    };
    let stop = AtomicBool::new(false);
    let bench = Bench {
        device,
        kernel,
        quick: true,
        correctly_rounded: device.info().kind == DeviceKind::Cpu,
        stop: &stop,
    };
    let ran = run(&all, &selected, &bench, &mut |_, _| {});
    assert!(ran.error.is_none(), "{:?}", ran.error);
    Some(ran)
}

/// The reason why the case of a run fails.
fn fails_by(check: &Check, name: &str) -> Vec<&'static str> {
    let case = check.cases.iter().find(|c| c.name == name).expect("a case");
    case.held
        .iter()
        .filter(|h| !h.passed())
        .map(|h| h.what)
        .collect()
}
