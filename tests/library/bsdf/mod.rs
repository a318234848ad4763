//! The surface model against independent results: tables, closed forms, its own samples.
//!
//! The numbers are those of model.md, "Checks". Statistical tests have fixed seeds, state their significance over the
//! whole family of a test (Šidák), and each comparator is shown to fail on a planted error.

mod albedo;
mod chain;
mod coloured;
mod densities;
mod extremes;
mod golden;
mod interface;
mod limits;
mod lobes;
mod micro_normals;
mod planted;
mod precision;
mod second_moment;
mod slopes;
mod support;
mod weights;
