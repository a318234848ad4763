//! Materials, tables and statistics for the tests of the surface model.

pub mod surface;
pub mod table;
