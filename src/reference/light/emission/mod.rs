//! Points of lights where light paths begin, uniform over their areas. Twin of `shaders/light/emission/`.

pub mod r#box;
pub mod cylinder;
pub mod mesh;
pub mod sphere;

pub use r#box::{box_emission, box_emission_pdf};
pub use cylinder::{cylinder_emission, cylinder_emission_pdf};
pub use mesh::{mesh_emission, mesh_emission_pdf};
pub use sphere::{sphere_emission, sphere_emission_pdf};

use crate::prepared::NONE;
use crate::reference::math::{Real, Vec3, vec3};

/// A point of a light, uniform over its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emission<F> {
    pub p: Vec3<F>,
    /// Outward, of unit length.
    pub n: Vec3<F>,
    /// Density per area; 0: no light path begins here.
    pub area_pdf: F,
    /// The face that the point is on, as in [`Hit::prim`](crate::reference::shape::Hit::prim).
    pub prim: u32,
}

/// The background sends out no light paths.
pub fn no_emission<F: Real>() -> Emission<F> {
    Emission {
        p: Vec3::zero(),
        n: vec3(F::zero(), F::zero(), F::one()),
        area_pdf: F::zero(),
        prim: NONE,
    }
}
