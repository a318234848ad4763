//! Pictures compared with each other, and renderers path by path.

pub mod command;
pub mod report;
