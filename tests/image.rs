//! Pictures: written, read again, and read from the files of other programs.

mod image {
    mod films;
    mod round_trips;
    mod writing;
}
