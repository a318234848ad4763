//! BSDFs (docs/model.md); twin of `shaders/bsdf/`.
//!
//! Everything is in the frame of N', the normal on `wo`'s side: `wo` points to the path's previous vertex and `wo.z >
//! 0`, `wi` to its next, and `wi.z < 0` where light is transmitted. Micro-normals `m` have `m.z > 0`. `eta` is n_o/n_i,
//! the index on `wo`'s side over that on the other. Where the kernel has a slot, filled once for the scene, the
//! functions here take `settings`, or inspect the material.
//!
//! | file | content | section |
//! |---|---|---|
//! | [`distribution`] | D, G1 and sampling of the three distributions | model.md, "Distributions and shadowing" |
//! | [`fresnel`] | Schlick's and exact reflectance | model.md, "Fresnel" |
//! | [`normals`] | which micro-normals are drawn, and their density | model.md, "Visible micro-normals" |
//! | [`choice`] | which lobe is drawn | model.md, "Choice of lobe" |
//! | [`snell`], [`facet`], [`reflection`], [`refraction`], [`transmission`], [`diffuse`] | one lobe's value and density | model.md, "Density and value" |
//! | [`scaling`] | radiance or flux | model.md, "Radiance scaling" |
//! | [`rough`] | the code that kinds with micro-normals share | model.md, "Sampling a direction" |
//! | [`kind`] | lobes combined, one file a kind of material | model.md, "Limits" |

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

pub use interaction::{Interaction, carried_mean, interaction};
pub use kind::{bsdf_eval, bsdf_sample};
pub use material::Material;
pub use sample::{
    BsdfRandom, BsdfSample, BsdfValue, LOBE_DELTA, LOBE_DIFFUSE, LOBE_NONE, LOBE_REFLECTION,
    LOBE_TRANSMISSION,
};
pub use scaling::transmission_scale;
