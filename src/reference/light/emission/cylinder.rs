//! Points of capped cylinders; twin of `shaders/light/emission/cylinder.glsl`.

use super::Emission;
use crate::reference::light::cylinder::cylinder_area;
use crate::reference::light::sample::{area_density, choice_below};
use crate::reference::math::frame::{to_local, to_world};
use crate::reference::math::{Real, Vec3, vec3};
use crate::reference::shape::{
    CYLINDER_BASE, CYLINDER_SIDE, CYLINDER_TOP, Cylinder, cylinder_frame,
};

/// Uniform over side, base and top, chosen by `u24` < 2²⁴: 2π r h, π r² and π r².
pub fn cylinder_emission<F: Real>(cylinder: &Cylinder<F>, u24: u32, u: [F; 2]) -> Emission<F> {
    let (zero, one) = (F::zero(), F::one());
    let side = F::new(std::f64::consts::TAU) * cylinder.radius * cylinder.height;
    let cap = F::new(std::f64::consts::PI) * cylinder.radius * cylinder.radius;
    let total = side + cap + cap;
    let choice = choice_below(u24, total);
    let on_side = choice < side;
    let on_base = !on_side && choice < side + cap;
    let (sin, cos) = F::sincos_2pi(u[0]);
    let (r, z, n) = if on_side {
        (
            cylinder.radius,
            cylinder.height * u[1],
            vec3(cos, sin, zero),
        )
    } else {
        let (z, out) = if on_base {
            (zero, -one)
        } else {
            (cylinder.height, one)
        };
        (cylinder.radius * u[1].sqrt(), z, vec3(zero, zero, out))
    };
    let part = match (on_side, on_base) {
        (true, _) => CYLINDER_SIDE,
        (_, true) => CYLINDER_BASE,
        _ => CYLINDER_TOP,
    };
    let frame = cylinder_frame(cylinder);
    Emission {
        p: cylinder.base + to_world(frame, vec3(cos * r, sin * r, z)),
        n: to_world(frame, n),
        area_pdf: area_density(total),
        prim: part,
    }
}

/// Density per area of `cylinder_emission` at a point that `p` sees; 0 from inside, where no light path goes.
pub fn cylinder_emission_pdf<F: Real>(p: Vec3<F>, cylinder: &Cylinder<F>) -> F {
    let side = F::new(std::f64::consts::TAU) * cylinder.radius * cylinder.height;
    let cap = F::new(std::f64::consts::PI) * cylinder.radius * cylinder.radius;
    let pl = to_local(cylinder_frame(cylinder), p - cylinder.base);
    if cylinder_area(pl, cylinder.radius, cylinder.height).inside {
        F::zero()
    } else {
        area_density(side + cap + cap)
    }
}
