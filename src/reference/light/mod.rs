//! Explicit sampling of emitters; twin of `shaders/light/`.
//!
//! Every `*_light_sample` draws a point of a light as seen from `p` and returns its density per solid angle;
//! `*_light_pdf` returns the density with which the same function would have drawn a point that a path has hit.
//! Densities per area become densities per solid angle by p_ω = p_A·r²/|N_L·w|, with one cosine (model.md,
//! "Connections").

pub mod background;
pub mod r#box;
pub mod choice;
pub mod cylinder;
pub mod emission;
pub mod mesh;
pub mod outside;
pub mod sample;
pub mod sphere;
pub mod surroundings;
pub mod tree;

pub use background::{background_light_pdf, background_light_sample, background_outside};
pub use r#box::{box_light_pdf, box_light_sample};
pub use choice::{cdf_choice, cdf_probability};
pub use cylinder::{cylinder_light_pdf, cylinder_light_sample};
pub use mesh::{mesh_light_pdf, mesh_light_sample};
pub use outside::Outside;
pub use sample::{LightSample, solid_angle_pdf};
pub use sphere::{sphere_light_pdf, sphere_light_sample};
pub use surroundings::{Surroundings, surroundings_light_sample, surroundings_outside};
