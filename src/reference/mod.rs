//! The CPU renderer: the reference with which the kernels are compared, written once and generic over the scalar.
//!
//! Same folders, file, function and argument names as `shaders/` (`tests/library/twin_names/` lists the differences and
//! their reasons). Reads `prepared`, never the GPU's buffers.
//!
//! Throughout, unless a function says otherwise: lengths are in the scene's unit and positions in rendering space;
//! directions have unit length; radiance is in W·sr⁻¹·m⁻² per channel of linear RGB; a `pdf` is per steradian, an
//! `area_pdf` or density of area per unit of length squared, a `pmf` or `p_…` a probability in [0, 1]; `u`, `u_…` are
//! uniform numbers in [0, 1), `u24` a uniform integer below 2²⁴.
//!
//! The surface model is specified in docs/model.md. Comments cite its headings, as in (model.md, "Fresnel").

pub mod accel;
pub mod bsdf;
pub mod camera;
pub mod film;
pub mod integrator;
pub mod light;
pub mod math;
pub mod path;
pub mod primitives;
pub mod sampler;
pub mod shape;
pub mod world;
