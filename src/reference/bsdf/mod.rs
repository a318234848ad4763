//! What a surface does with light (model page, sections 2 to 8); twin of `shaders/bsdf/`.
//!
//! Everything is in the frame of N', the normal on `wo`'s side: `wo` points to the path's previous vertex and
//! `wo.z > 0`, `wi` to its next, and `wi.z < 0` where light is transmitted. Micro-normals `m` have `m.z > 0`.
//! `eta` is n_o/n_i, the index on `wo`'s side over that on the other. Where the kernel has a slot, filled once
//! for the scene, the functions here take `settings`, or look at the material.
//!
//! | file | page |
//! |---|---|
//! | [`distribution`] | D, G1 and sampling of the three distributions (3, 5.2) |
//! | [`fresnel`] | Schlick and exact (4) |
//! | [`normals`] | which micro-normals are drawn, and their density (5.2, 5.3) |
//! | [`choice`] | which lobe is drawn (5.1) |
//! | [`snell`], [`facet`], [`reflection`], [`refraction`], [`transmission`], [`diffuse`] | one lobe's value and density (5.4 to 6) |
//! | [`scaling`] | radiance or flux (7) |
//! | [`rough`] | what the kinds with micro-normals share (5, 6) |
//! | [`kind`] | lobes put together, one file a kind of material (5, 6, 8) |

pub mod choice;
pub mod diffuse;
pub mod distribution;
pub mod facet;
pub mod fresnel;
pub mod interaction;
pub mod kind;
pub mod material;
pub mod normals;
pub mod reflection;
pub mod refraction;
pub mod rough;
pub mod sample;
pub mod scaling;
pub mod snell;
pub mod transmission;

pub use interaction::{Interaction, interaction};
pub use kind::{bsdf_eval, bsdf_sample};
pub use material::Material;
pub use sample::{
    BsdfSample, BsdfValue, LOBE_DELTA, LOBE_DIFFUSE, LOBE_NONE, LOBE_REFLECTION, LOBE_TRANSMISSION,
};
pub use scaling::transmission_scale;
