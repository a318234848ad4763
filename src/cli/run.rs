//! A command line from its words to its exit code.

use std::ffi::OsString;

use super::arguments::{Task, help, task};
use super::command;
use super::exit::{Ending, Failure, exit};
use super::limits::meet_limits;

/// Does what the words ask for, the program's name first.
pub fn run(words: impl Iterator<Item = OsString>) -> u8 {
    let words = command::keep(words);
    exit(meet_limits().and_then(|()| end_of(words)))
}

fn end_of(words: &[OsString]) -> Result<Ending, Failure> {
    match task(words)? {
        Task::Render(arguments) => super::render(&arguments),
        Task::Compare(arguments) => super::compare(&arguments),
        Task::Converge(arguments) => super::converge(&arguments),
        Task::Check(arguments) => super::check(&arguments),
        Task::Test(arguments) => super::test(&arguments),
        Task::Merge(arguments) => super::merge(&arguments),
        Task::Explain(arguments) => super::explain(&arguments),
        Task::Export(arguments) => super::export(&arguments),
        Task::Farm(arguments) => super::farm(&arguments),
        Task::Doctor(arguments) => super::doctor(&arguments),
        Task::Devices => super::devices(),
        Task::Init(arguments) => super::init(&arguments),
        Task::Help(text) => help(&text),
    }
}
