//! Expected values of pictures, by closed forms and one-dimensional quadrature: implemented independently from the papers,
//! in f64 and with angles, and not shared with either renderer.

pub mod interface;
pub mod polygon;
pub mod slab;
