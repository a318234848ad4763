//! A surface seen from one direction; twin of `shaders/bsdf/interaction.glsl`.

use super::material::Material;
use crate::reference::math::{Real, Vec3, max2, mean3, min2};

/// A material and the side of it that `wo` is on.
#[derive(Clone, Copy, Debug)]
pub struct Interaction<F> {
    pub material: Material<F>,
    /// To the path's previous vertex, of unit length, in the frame of N': wo.z > 0, except for rays that just graze a
    /// surface (0) and shading normals that turn away from them (below 0), where only Kd scatters.
    pub wo: Vec3<F>,
    /// n_o / n_i.
    pub eta: F,
    /// 1 − eta², rounded from f64: an `eta` near 1 has lost it.
    pub one_minus_eta2: F,
    /// (n_i / n_o)² − 1, rounded from f64.
    pub d: F,
    /// A(t) of the segment that led here inside the medium, with absorption by `term`; 1 otherwise. It appears wherever
    /// E_t does, so one formula serves both settings.
    pub attenuation: Vec3<F>,
    /// The path's throughput over its mean, by which the choice of lobe weighs channels; 1 unless the path sets it.
    pub carried: Vec3<F>,
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
        carried: Vec3::one(),
    }
}

/// The mean of `f` weighted by the throughput, within [0, 1]: Σ βf/Σ β, which for a grey `f` is `f` to the bit.
///
/// If R is this mean, a reflection of weight f/R leaves the mean of the path's throughput as it is; with the plain mean
/// of f the channels would drift apart, each with a variance that grows at every choice.
pub fn carried_mean<F: Real>(at: &Interaction<F>, f: Vec3<F>) -> F {
    let mean = mean3(f);
    let weighted = mean + mean3(at.carried * (f - Vec3::splat(mean)));
    min2(max2(weighted, F::zero()), F::one())
}
