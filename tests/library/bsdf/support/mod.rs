//! Materials, tables, random numbers, quadrature and statistics for the tests of the surface model.

pub mod albedo;
pub mod chi_square;
pub mod moments;
pub mod quadrature;
pub mod random;
pub mod rqmc;
pub mod statistics;
pub mod surface;
