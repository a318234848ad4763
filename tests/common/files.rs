//! The files of a folder.

use std::fs;
use std::path::{Path, PathBuf};

/// The files below `folder`, in order; of the folders in it those that `enters`.
pub fn below(folder: &Path, enters: &dyn Fn(&Path) -> bool) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    let files = paths.into_iter().flat_map(|path| match path.is_dir() {
        true if enters(&path) => below(&path, enters),
        true => Vec::new(),
        false => vec![path],
    });
    files.collect()
}
