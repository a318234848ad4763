//! The files of tests/data.

use std::path::PathBuf;

/// The path of `tests/data/NAME`. A test that needs a file fails without it.
pub fn data(name: &str) -> PathBuf {
    let path = super::root().join("tests/data").join(name);
    assert!(
        path.exists(),
        "{} is missing; it is part of this repository",
        path.display()
    );
    path
}
