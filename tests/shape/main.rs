//! Intersection against closed forms in f64, at every scale, and what must never happen: leaks and acne.

#[path = "../common/icosphere.rs"]
mod icosphere;
mod linear;
mod mesh;
mod random;
mod solids;
mod starts;
mod surfaces;
