//! The memory that a scene takes on the host, announced beforehand.

use crate::cli::exit::{Failure, note, warn};
use vkpt::memory::{free, in_use};
use vkpt::prepared::Footprint;
use vkpt::report::human::{bytes, thousands};
use vkpt::scene::Scene;

/// Scenes that take more are announced.
const LARGE: u64 = 1 << 30;

/// Announces the memory of a large scene; warns if it is not free without swapping, and fails if it is not free at all.
pub fn announce(scene: &Scene, quiet: bool) -> Result<(), Failure> {
    let footprint = Footprint::of(scene);
    let needed = footprint.peak();
    let what = format!(
        "{} take about {} of memory",
        parts(footprint),
        bytes(needed)
    );
    // The scene itself is already in memory.
    let used = in_use().unwrap_or(0);
    match free() {
        Some(free) if free.all + used < needed => {
            let had = bytes(free.all + used);
            return Err(Failure::Memory(format!(
                "{what}, but only {had} is available"
            )));
        }
        Some(free) if free.quick + used < needed => {
            let had = bytes(free.quick + used);
            warn(&format!(
                "{what}, but only {had} is available without swapping"
            ));
        }
        _ if needed > LARGE && !quiet => note(&what),
        _ => {}
    }
    Ok(())
}

/// The contents of the memory, in words.
fn parts(footprint: Footprint) -> String {
    let Footprint {
        triangles, texels, ..
    } = footprint;
    let triangles = (triangles, format!("{} triangles", thousands(triangles)));
    let texels = (
        texels,
        format!("{} texels of surroundings", thousands(texels)),
    );
    let there = [triangles, texels].into_iter().filter(|part| part.0 > 0);
    there.map(|part| part.1).collect::<Vec<_>>().join(" and ")
}
