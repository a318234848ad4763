//! The host's memory: what is free, and what this process took.

use super::exit::{note, warn};
use crate::prepared::triangles_and_peak;
use crate::report::human::{bytes, thousands};
use crate::scene::Scene;

/// Scenes that take more say so before they do.
const LARGE: u64 = 1 << 30;

/// Says what a large scene will take; warns where that is not free.
pub fn announce(scene: &Scene) {
    let (triangles, needed) = triangles_and_peak(scene);
    let what = format!(
        "{} triangles take about {} of memory",
        thousands(triangles),
        bytes(needed)
    );
    match available().filter(|&free| free < needed) {
        Some(free) => warn(&format!("{what}, and {} are free", bytes(free))),
        None if needed > LARGE => note(&what),
        None => {}
    }
}

/// The most memory that this process has held at once, where Linux tells.
pub fn peak() -> Option<u64> {
    kibibytes("/proc/self/status", "VmHWM:")
}

/// What the machine can give without swapping, where Linux tells.
fn available() -> Option<u64> {
    kibibytes("/proc/meminfo", "MemAvailable:")
}

/// A line `NAME 123 kB` of a file, in bytes.
fn kibibytes(file: &str, name: &str) -> Option<u64> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib * 1024)
}
