//! The tools around the renderer vkpt: what a picture is worth, and why it comes out as it does.
//!
//! Each tool is a folder with its measurement, its report as records, tables and pages, and its command line.

pub mod check;
pub mod cli;
pub mod compare;
pub mod converge;
pub mod doctor;
pub mod explain;
pub mod page;
pub mod suite;
mod table;
