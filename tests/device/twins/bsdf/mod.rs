//! Twins of `shaders/bsdf/`: rows in the folder next to this file, one file a group of functions.

mod inputs;
mod kernel;
mod kinds;
mod lobes;
mod micro_normals;
mod slots;
mod visible;

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    [
        micro_normals::twins(),
        slots::twins(),
        visible::twins(),
        lobes::twins(),
        kinds::twins(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
