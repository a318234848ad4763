//! Pictures: written, read again, and read from the files of other programs.

mod films;
mod fuzz;
mod hdr_png;
mod openexr;
mod precision;
mod refusals;
mod round_trips;
mod writing;
