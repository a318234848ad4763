//! Twins of `shaders/bsdf/`.

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    vec![]
}
