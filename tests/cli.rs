//! The program itself: help, refusals, exit codes, and that a refusal leaves no file.

mod cli {
    mod compare;
    mod help;
    mod interrupt;
    mod paired;
    pub mod program;
    mod readme;
    mod refusals;
    mod rendering;
}
