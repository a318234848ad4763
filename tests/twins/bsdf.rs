//! Twins of `shaders/bsdf/`: rows in the folder beside this file, one file a group of functions.

#[path = "bsdf/inputs.rs"]
mod inputs;
#[path = "bsdf/kernel.rs"]
mod kernel;
#[path = "bsdf/kinds.rs"]
mod kinds;
#[path = "bsdf/lobes.rs"]
mod lobes;
#[path = "bsdf/micro_normals.rs"]
mod micro_normals;
#[path = "bsdf/slots.rs"]
mod slots;

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    [
        micro_normals::twins(),
        slots::twins(),
        lobes::twins(),
        kinds::twins(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
