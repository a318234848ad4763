//! The files of `shaders/`, embedded.

/// (name, text), sorted by name; see `build.rs`.
const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/shaders.rs"));

/// The text of a file, by its path below `shaders/` without `.glsl` (a root keeps its `.comp`).
pub fn file(name: &str) -> Option<&'static str> {
    let i = FILES.binary_search_by(|(n, _)| (*n).cmp(name)).ok()?;
    Some(FILES[i].1)
}

/// The names of all files.
pub fn files() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(name, _)| *name)
}
