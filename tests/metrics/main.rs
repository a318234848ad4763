//! The metrics against closed forms and other programs' numbers; each of them fails on a planted error.

mod closed_forms;
mod flip;
mod pictures;
mod refusals;
