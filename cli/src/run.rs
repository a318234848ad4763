//! A command line from its words to its exit code.

use std::ffi::OsString;

use vkpt_lab::check::command::check;
use vkpt_lab::cli::command;
use vkpt_lab::cli::exit::{Ending, Failure, exit};
use vkpt_lab::compare::command::compare;
use vkpt_lab::converge::command::converge;
use vkpt_lab::doctor::command::doctor;
use vkpt_lab::explain::command::explain;
use vkpt_lab::suite::command::test;

use crate::arguments::{Task, help, task};
use crate::devices::devices;
use crate::export::command::export;
use crate::farm::command::farm;
use crate::init::init;
use crate::limits::meet_limits;
use crate::merge::merge;
use crate::render::render;

/// Does what the words ask for, the program's name first.
pub fn run(words: impl Iterator<Item = OsString>) -> u8 {
    let words = command::keep(words);
    exit(meet_limits().and_then(|()| end_of(words)))
}

fn end_of(words: &[OsString]) -> Result<Ending, Failure> {
    match task(words)? {
        Task::Render(arguments) => render(&arguments),
        Task::Compare(arguments) => compare(&arguments),
        Task::Converge(arguments) => converge(&arguments),
        Task::Check(arguments) => check(&arguments),
        Task::Test(arguments) => test(&arguments),
        Task::Merge(arguments) => merge(&arguments),
        Task::Explain(arguments) => explain(&arguments),
        Task::Export(arguments) => export(&arguments),
        Task::Farm(arguments) => farm(&arguments),
        Task::Doctor(arguments) => doctor(&arguments),
        Task::Devices => devices(),
        Task::Init(arguments) => init(&arguments),
        Task::Help(text) => help(&text),
    }
}
