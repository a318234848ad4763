//! The lens: its rays against geometry in f64, its pictures against closed forms and quadrature, and its integrators against
//! one another; by the reference, which the device equals bit for bit (`tests/device/lens.rs`).

mod floor;
mod pictures;
mod rays;
mod warnings;
