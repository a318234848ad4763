//! What a scene takes of the host's memory, said before it does.

use super::exit::{Failure, note, warn};
use crate::memory::free;
use crate::prepared::triangles_and_peak;
use crate::report::human::{bytes, thousands};
use crate::scene::Scene;

/// Scenes that take more say so before they do.
const LARGE: u64 = 1 << 30;

/// Says what a large scene will take; warns where that is not free without swapping, and fails where it is not free at
/// all.
pub fn announce(scene: &Scene, quiet: bool) -> Result<(), Failure> {
    let (triangles, needed) = triangles_and_peak(scene);
    let what = format!(
        "{} triangles take about {} of memory",
        thousands(triangles),
        bytes(needed)
    );
    match free() {
        Some(free) if free.all < needed => {
            let free = bytes(free.all);
            return Err(Failure::Memory(format!("{what}, and {free} are free")));
        }
        Some(free) if free.quick < needed => {
            let quick = bytes(free.quick);
            warn(&format!("{what}, and {quick} are free without swapping"));
        }
        _ if needed > LARGE && !quiet => note(&what),
        _ => {}
    }
    Ok(())
}
