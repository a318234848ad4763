//! What a scene takes of the host's memory, said before it does.

use super::exit::{Failure, note, warn};
use crate::memory::{free, held};
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
    // The scene itself is there already.
    let held = held().unwrap_or(0);
    match free() {
        Some(free) if free.all + held < needed => {
            let had = bytes(free.all + held);
            return Err(Failure::Memory(format!("{what}, and {had} can be had")));
        }
        Some(free) if free.quick + held < needed => {
            let had = bytes(free.quick + held);
            warn(&format!("{what}, and {had} can be had without swapping"));
        }
        _ if needed > LARGE && !quiet => note(&what),
        _ => {}
    }
    Ok(())
}
