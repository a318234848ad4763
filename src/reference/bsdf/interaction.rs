//! A surface seen from one direction; twin of `shaders/bsdf/interaction.glsl`.

use super::material::Material;
use crate::reference::math::{Real, Vec3};

/// A material and the side of it that `wo` is on.
#[derive(Clone, Copy, Debug)]
pub struct Interaction<F> {
    pub material: Material<F>,
    /// To the path's previous vertex, of unit length, in the frame of N': wo.z > 0, but for rays that just graze a
    /// surface (0) and shading normals that turn away from them (below 0), where only Kd scatters.
    pub wo: Vec3<F>,
    /// n_o / n_i.
    pub eta: F,
    /// 1 − eta², rounded from f64: an `eta` near 1 has lost it.
    pub one_minus_eta2: F,
    /// (n_i / n_o)² − 1, rounded from f64.
    pub d: F,
    /// A(t) of the stretch that led here inside the medium, with absorption by `term`; 1 otherwise. It stands
    /// wherever E_t does, so one formula serves both settings.
    pub attenuation: Vec3<F>,
}

/// `material` seen from `wo`, which is on the outer side if `outside`.
pub fn interaction<F: Real>(
    material: Material<F>,
    outside: bool,
    wo: Vec3<F>,
    attenuation: Vec3<F>,
) -> Interaction<F> {
    let side = usize::from(!outside);
    Interaction {
        material,
        wo,
        eta: material.eta[side],
        one_minus_eta2: material.one_minus_eta2[side],
        d: material.d[side],
        attenuation,
    }
}
