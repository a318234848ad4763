//! What a scene takes of the host's memory, said before it does.

use crate::cli::exit::{Failure, note, warn};
use vkpt::memory::{free, held};
use vkpt::prepared::Footprint;
use vkpt::report::human::{bytes, thousands};
use vkpt::scene::Scene;

/// Scenes that take more say so before they do.
const LARGE: u64 = 1 << 30;

/// Says what a large scene will take; warns where that is not free without swapping, and fails where it is not free at
/// all.
pub fn announce(scene: &Scene, quiet: bool) -> Result<(), Failure> {
    let footprint = Footprint::of(scene);
    let needed = footprint.peak();
    let what = format!(
        "{} take about {} of memory",
        parts(footprint),
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

/// What takes the memory, in words.
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
