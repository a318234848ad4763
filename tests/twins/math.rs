//! Twins of `shaders/math/`.

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    vec![]
}
