//! What pictures come to, by closed forms and one-dimensional quadrature: written down once more from the papers, in f64
//! and with angles, and not shared with either renderer.

pub mod interface;
pub mod polygon;
pub mod slab;
