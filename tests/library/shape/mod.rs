//! Intersection against closed forms in f64, at every scale, and errors that must never happen: leaks and acne.

mod linear;
mod mesh;
pub mod random;
mod solids;
mod starts;
mod surfaces;
