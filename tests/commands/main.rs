//! The program: its command line, its ends on devices that fail, and its pages in a browser.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by a panic")]

#[path = "../common/mod.rs"]
mod common;

mod cli;
mod cli_page;
mod documented;
mod farm;
#[cfg(target_os = "linux")]
mod faults;
mod output;
mod packaging;
mod pages;
mod report_page;
mod scripts;
mod tutorial;
