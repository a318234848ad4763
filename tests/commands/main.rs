//! The program: its command line, and its pages in a browser.

#[path = "../common/mod.rs"]
mod common;

mod cli;
mod report_page;
mod scripts;
