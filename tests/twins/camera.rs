//! Twins of `shaders/camera/`.

use super::harness::Twin;

pub fn twins() -> Vec<Twin> {
    vec![]
}
