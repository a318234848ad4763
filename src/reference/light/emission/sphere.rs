//! Points of spheres; twin of `shaders/light/emission/sphere.glsl`.

use super::Emission;
use crate::reference::light::sample::unit_sphere;
use crate::reference::light::sphere::sphere_density;
use crate::reference::math::{Real, Vec3, length3};

/// Uniform over the sphere, p_A = 1/(4π r²).
pub fn sphere_emission<F: Real>(centre: Vec3<F>, radius: F, u: [F; 2]) -> Emission<F> {
    let n = unit_sphere(u);
    Emission {
        p: centre + n * radius,
        n,
        area_pdf: sphere_density(radius),
        prim: 0,
    }
}

/// Density per area of `sphere_emission` at a point that `p` sees; 0 from inside, where no light path goes.
pub fn sphere_emission_pdf<F: Real>(p: Vec3<F>, centre: Vec3<F>, radius: F) -> F {
    if length3(centre - p) > radius {
        sphere_density(radius)
    } else {
        F::zero()
    }
}
