//! Light samplers against their densities, closed forms and quadrature.
//!
//! Fixed seeds; every family of tests has the level α = 1e-3, shared out after Šidák.

mod closed_forms;
mod density;
mod emitter;
mod extremes;
mod surroundings;
mod window;

/// Level of a family of tests.
const ALPHA: f64 = 1e-3;
