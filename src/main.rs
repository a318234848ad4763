//! vkpt renders a scene file to pictures on a Vulkan device, or on the CPU.
//!
//! The way of the data:
//!
//! 1. `scene` reads text and meshes into a `Scene`: names, units, f64;
//! 2. `prepared` derives what both renderers share;
//! 3. `render` turns it into a `Film`: composed kernels (`features`, `flat`, `kernel`) on a device (`gpu`), or
//!    the CPU reference (`reference`);
//! 4. `image` writes the film, `report` tells what it took.
//!
//! `cli` knows them all; none of them knows `cli`, and nothing but `cli` prints.

use std::process::ExitCode;

use vkpt::cli::{self, Task};

fn main() -> ExitCode {
    let ending = match cli::meet_limits().and_then(|()| cli::task()) {
        Ok(Task::Render(arguments)) => cli::render(&arguments),
        Ok(Task::Compare(arguments)) => cli::compare(&arguments),
        Ok(Task::Converge(arguments)) => cli::converge(&arguments),
        Ok(Task::Check(arguments)) => cli::check(&arguments),
        Ok(Task::Test(arguments)) => cli::test(&arguments),
        Ok(Task::Merge(arguments)) => cli::merge(&arguments),
        Ok(Task::Explain(arguments)) => cli::explain(&arguments),
        Ok(Task::Export(arguments)) => cli::export(&arguments),
        Ok(Task::Farm(arguments)) => cli::farm(&arguments),
        Ok(Task::Doctor(arguments)) => cli::doctor(&arguments),
        Ok(Task::Devices) => cli::devices(),
        Ok(Task::Init(arguments)) => cli::init(&arguments),
        Ok(Task::Help(text)) => cli::help(&text),
        Err(failure) => Err(failure),
    };
    cli::exit(ending)
}
