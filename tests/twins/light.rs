//! Twins of `shaders/light/`.

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    vec![]
}
