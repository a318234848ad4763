//! The plane of incidence; twin of `shaders/bsdf/normals/visible/incidence.glsl`.

use crate::reference::math::{Real, Vec3, max2, vec3};

/// The azimuth and inclination of `wo`.
#[derive(Clone, Copy, Debug)]
pub struct Incidence<F> {
    /// Sine of the angle between `wo` and N'.
    pub sine: F,
    /// Its azimuth; 0 along N'.
    pub cos_phi: F,
    pub sin_phi: F,
}

/// The plane of `wo` and N'.
pub fn incidence<F: Real>(wo: Vec3<F>) -> Incidence<F> {
    let sine = (wo.x * wo.x + wo.y * wo.y).sqrt();
    let leans = sine > F::zero();
    Incidence {
        sine,
        cos_phi: if leans { wo.x / sine } else { F::one() },
        sin_phi: if leans { wo.y / sine } else { F::zero() },
    }
}

/// From (along the plane, across it, up) to the frame of N'.
pub fn incidence_to_frame<F: Real>(plane: Incidence<F>, v: Vec3<F>) -> Vec3<F> {
    vec3(
        v.x * plane.cos_phi - v.y * plane.sin_phi,
        v.x * plane.sin_phi + v.y * plane.cos_phi,
        v.z,
    )
}

/// And back.
pub fn incidence_from_frame<F: Real>(plane: Incidence<F>, v: Vec3<F>) -> Vec3<F> {
    vec3(
        v.x * plane.cos_phi + v.y * plane.sin_phi,
        v.y * plane.cos_phi - v.x * plane.sin_phi,
        v.z,
    )
}

/// `u` moved away from 0, where a Gaussian ends at infinity: at least the least nonzero uniform number.
pub fn above_zero<F: Real>(u: F) -> F {
    max2(u, F::new(5.960_464_477_539_063e-8))
}
