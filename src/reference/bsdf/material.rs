//! A prepared material, rounded to the scalar; in the kernels the record of the same name.

pub use crate::prepared::record::material::scalar::Material;
