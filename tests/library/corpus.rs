//! The inputs of `fuzz/` that are kept, replayed without libFuzzer: a small corpus, and all inputs that once failed.

use std::fs;
use std::path::{Path, PathBuf};

use crate::bodies;

/// Panics if an invariant that must hold for any bytes is broken.
type Body = fn(&[u8]);

/// Each fuzz target and its body.
const TARGETS: [(&str, Body); 7] = [
    ("scene", bodies::scene),
    ("ply", bodies::ply),
    ("obj", bodies::obj),
    ("gltf", bodies::gltf),
    ("model", bodies::model),
    ("part", bodies::part),
    ("picture", bodies::picture),
];

/// The files of a folder, sorted.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    paths
}

/// Runs a body over all files of `fuzz/{kind}/{target}` and returns how many there were.
fn replay(kind: &str, target: &str, body: Body) -> usize {
    let inputs = files(&Path::new("fuzz").join(kind).join(target));
    for path in &inputs {
        // The test's output is shown where it fails: its last line names the file.
        println!("{}", path.display());
        body(&fs::read(path).expect("a file"));
    }
    inputs.len()
}

#[test]
fn kept_inputs_satisfy_the_invariants() {
    for (target, body) in TARGETS {
        let corpus = replay("corpus", target, body);
        assert!(corpus > 20, "{target}: only {corpus} inputs");
        replay("regressions", target, body);
    }
}

/// No target is without a body here.
#[test]
fn every_target_is_replayed() {
    let mut names = TARGETS.map(|(target, _)| target);
    names.sort_unstable();
    let targets = files(Path::new("fuzz/fuzz_targets"));
    let stems: Vec<_> = targets
        .iter()
        .map(|path| path.file_stem().expect("a name"))
        .collect();
    assert_eq!(stems, names);
}
