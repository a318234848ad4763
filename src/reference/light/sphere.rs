//! Spheres as lights; twin of `shaders/light/sphere.glsl`.

use super::sample::{LightSample, area_density, area_sample, solid_angle_pdf, unit_sphere};
use crate::reference::math::frame::{frame_about, to_world};
use crate::reference::math::{Real, Vec3, length3, vec3};

/// 4π
const FOUR_PI: f64 = 12.566_370_614_359_172;
/// 1/2π
const INV_2PI: f64 = 0.159_154_943_091_895_35;

/// 1 − cos θ_max of the cone that a sphere of radius r subtends at a distance d > r from its centre.
///
/// sin²θ_max/(1 + cos θ_max), with sin = r/d and cos² = (1 − sin)(1 + sin): no digit is lost, even for tiny spheres or
/// next to the surface.
pub fn cone_height<F: Real>(radius: F, distance: F) -> F {
    let one = F::one();
    let sin = radius / distance;
    let cos = ((distance - radius) / distance * (one + sin)).sqrt();
    sin * sin / (one + cos)
}

/// A direction uniform in the cone that the sphere subtends; from inside, or from a point on it, where no cone exists,
/// a point uniform on the sphere.
pub fn sphere_light_sample<F: Real>(
    p: Vec3<F>,
    centre: Vec3<F>,
    radius: F,
    u: [F; 2],
) -> LightSample<F> {
    let distance = length3(centre - p);
    if distance > radius {
        cone_sample(centre - p, distance, radius, u)
    } else {
        let n = unit_sphere(u);
        area_sample(centre - p + n * radius, n, sphere_density(radius), 0)
    }
}

/// Density of `sphere_light_sample` at a point that a path has hit at `distance` with the cosine `cosine` = |N_L·w|;
/// both matter only from inside.
pub fn sphere_light_pdf<F: Real>(
    p: Vec3<F>,
    centre: Vec3<F>,
    radius: F,
    distance: F,
    cosine: F,
) -> F {
    let d = length3(centre - p);
    if d > radius {
        cone_pdf(cone_height(radius, d))
    } else {
        solid_angle_pdf(sphere_density(radius), distance, cosine)
    }
}

/// 1/(4πr²)
pub fn sphere_density<F: Real>(radius: F) -> F {
    area_density(F::new(FOUR_PI) * (radius * radius))
}

/// 1/(2π(1 − cos θ_max)); 0 for a sphere so small that f32 cannot represent it.
pub fn cone_pdf<F: Real>(height: F) -> F {
    let lost = height < F::new(1e-37);
    let pdf = F::new(INV_2PI) / if lost { F::one() } else { height };
    if lost { F::zero() } else { pdf }
}

/// Uniform in the cone about `axis`, of length `d`: 1 − cos θ = h = u₁(1 − cos θ_max), sin²θ = h(2 − h).
///
/// The distance to the near side is (d² − r²)/(d cos θ + √(r² − d² sin²θ)), where the root is
/// d √((h_max − h)(2 − h_max − h)), since r = d sin θ_max.
pub fn cone_sample<F: Real>(axis: Vec3<F>, d: F, radius: F, u: [F; 2]) -> LightSample<F> {
    let one = F::one();
    let two = F::new(2.0);
    let height = cone_height(radius, d);
    let h = u[0] * height;
    let root = (height * (one - u[0]) * (two - height - h)).sqrt();
    LightSample {
        wi: to_world(frame_about(axis / d), cone_direction(height, u)),
        distance: (d - radius) * ((d + radius) / d) / (one - h + root),
        pdf: cone_pdf(height),
        cosine: root * d / radius,
        prim: 0,
    }
}

/// A direction uniform in a cone about z, 1 − cos θ = h = u₁ `height`, sin²θ = h(2 − h).
pub fn cone_direction<F: Real>(height: F, u: [F; 2]) -> Vec3<F> {
    let h = u[0] * height;
    let sin = (h * (F::new(2.0) - h)).sqrt();
    let (sin_phi, cos_phi) = F::sincos_2pi(u[1]);
    vec3(sin * cos_phi, sin * sin_phi, F::one() - h)
}
