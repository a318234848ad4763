//! Twins of `shaders/shape/`.

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    vec![]
}
