//! Twins of `shaders/sampler/`.

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    vec![]
}
