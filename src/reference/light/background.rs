//! The constant background as a light; twin of `shaders/light/background.glsl`.

use super::outside::Outside;
use super::sample::{LightSample, unit_sphere};
use crate::prepared::NONE;
use crate::reference::math::{Real, Vec3};

/// 1/4π
pub fn background_light_pdf<F: Real>() -> F {
    F::new(0.079_577_471_545_947_67)
}

/// A direction uniform over the sphere.
pub fn background_light_sample<F: Real>(u: [F; 2]) -> LightSample<F> {
    LightSample {
        wi: unit_sphere(u),
        distance: -F::one(),
        pdf: background_light_pdf(),
        cosine: F::one(),
        prim: NONE,
    }
}

/// The same along every direction.
pub fn background_outside<F: Real>(radiance: Vec3<F>) -> Outside<F> {
    Outside {
        radiance,
        pdf: background_light_pdf(),
    }
}
