//! The program: its command line, its ends on devices that fail, and its pages in a browser.

#[path = "../common/mod.rs"]
mod common;

mod cli;
mod documented;
mod farm;
#[cfg(target_os = "linux")]
mod faults;
mod packaging;
mod report_page;
mod scripts;
