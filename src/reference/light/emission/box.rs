//! Points of axis-aligned boxes; twin of `shaders/light/emission/box.glsl`.

use super::Emission;
use crate::reference::light::r#box::face_areas;
use crate::reference::light::sample::{area_density, choice_below};
use crate::reference::math::{Real, Vec3, vec3};

/// Uniform over the six faces; the face is chosen by `u24` < 2²⁴: first the lower faces across x, y and z, then the
/// upper.
pub fn box_emission<F: Real>(lo: Vec3<F>, hi: Vec3<F>, u24: u32, u: [F; 2]) -> Emission<F> {
    let (zero, one) = (F::zero(), F::one());
    let e = hi - lo;
    let area = vec3(e.y * e.z, e.z * e.x, e.x * e.y);
    let lower = area.x + area.y + area.z;
    let choice = choice_below(u24, lower + lower);
    let upper = choice >= lower;
    let rest = if upper { choice - lower } else { choice };
    let x = rest < area.x;
    let y = !x && rest < area.x + area.y;
    let z = !x && !y;
    let (side, out) = if upper { (one, one) } else { (zero, -one) };
    let pick = |chosen: bool, a: F, b: F| if chosen { a } else { b };
    let at = vec3(
        pick(x, side, u[0]),
        pick(y, side, pick(x, u[0], u[1])),
        pick(z, side, u[1]),
    );
    let axis = match (x, y) {
        (true, _) => 0,
        (_, true) => 1,
        _ => 2,
    };
    Emission {
        p: lo + e * at,
        n: vec3(pick(x, out, zero), pick(y, out, zero), pick(z, out, zero)),
        area_pdf: area_density(lower + lower),
        prim: 2 * axis + u32::from(upper),
    }
}

/// Whether `p` lies outside the box.
pub fn is_outside<F: Real>(p: Vec3<F>, lo: Vec3<F>, hi: Vec3<F>) -> bool {
    let beyond = |p: F, lo: F, hi: F| p < lo || hi < p;
    beyond(p.x, lo.x, hi.x) || beyond(p.y, lo.y, hi.y) || beyond(p.z, lo.z, hi.z)
}

/// Density per area of `box_emission` at a point that `p` sees; 0 from inside, where no light path goes.
pub fn box_emission_pdf<F: Real>(p: Vec3<F>, lo: Vec3<F>, hi: Vec3<F>) -> F {
    let area = face_areas(hi - lo);
    let lower = area.x + area.y + area.z;
    if is_outside(p, lo, hi) {
        area_density(lower + lower)
    } else {
        F::zero()
    }
}
