//! The result of a light sampler; twin of `shaders/light/sample.glsl`.

use crate::prepared::NONE;
use crate::reference::math::{Real, Vec3, dot3, length3, vec3};

/// A direction to a point of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample<F> {
    /// Unit length.
    pub wi: Vec3<F>,
    /// To the point; −1: the background, beyond everything.
    pub distance: F,
    /// Per steradian; 0: no sample, and the other fields are meaningless.
    pub pdf: F,
    /// |N_L·wi| at the point.
    pub cosine: F,
    /// The face that the point is on, as in [`Hit::prim`](crate::reference::shape::Hit::prim): with the light's shape,
    /// the target of a shadow ray. For surroundings the texel.
    pub prim: u32,
}

impl<F: Real> LightSample<F> {
    /// No sample.
    pub fn none() -> Self {
        Self {
            wi: Vec3::zero(),
            distance: -F::one(),
            pdf: F::zero(),
            cosine: F::one(),
            prim: NONE,
        }
    }
}

/// 1/area; 0 for no area.
pub fn area_density<F: Real>(area: F) -> F {
    let some = area > F::zero();
    let density = F::one() / if some { area } else { F::one() };
    if some { density } else { F::zero() }
}

/// p_ω = p_A·r²/|N_L·w|; 0 where the light is seen edge-on.
pub fn solid_angle_pdf<F: Real>(area_pdf: F, distance: F, cosine: F) -> F {
    let some = cosine > F::zero();
    let pdf = area_pdf * (distance * distance) / if some { cosine } else { F::one() };
    if some { pdf } else { F::zero() }
}

/// The sample at a point of a light with normal `n`, `to` = point − p, drawn with `area_pdf` per area.
pub fn area_sample<F: Real>(to: Vec3<F>, n: Vec3<F>, area_pdf: F, prim: u32) -> LightSample<F> {
    let distance = length3(to);
    let wi = to
        / if distance > F::zero() {
            distance
        } else {
            F::one()
        };
    let cosine = dot3(wi, n).abs();
    LightSample {
        wi,
        distance,
        pdf: solid_angle_pdf(area_pdf, distance, cosine),
        cosine,
        prim,
    }
}

/// A direction uniform over the unit sphere: z = 1 − 2 u₁, √(1 − z²) = 2√(u₁(1 − u₁)).
pub fn unit_sphere<F: Real>(u: [F; 2]) -> Vec3<F> {
    let z = F::one() - (u[0] + u[0]);
    let r = F::new(2.0) * (u[0] * (F::one() - u[0])).sqrt();
    let (sin, cos) = F::sincos_2pi(u[1]);
    vec3(r * cos, r * sin, z)
}

/// A choice in [0, total) from `u24` < 2²⁴; rounding never reaches `total`.
pub fn choice_below<F: Real>(u24: u32, total: F) -> F {
    F::from_u32(u24) * F::new(1.0 / 16_777_216.0) * total
}
