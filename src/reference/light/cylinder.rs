//! Capped cylinders as lights; twin of `shaders/light/cylinder.glsl`.

use super::sample::{LightSample, area_density, area_sample, choice_below, solid_angle_pdf};
use crate::reference::math::frame::{to_local, to_world};
use crate::reference::math::{Real, Vec3, dot3, vec3};
use crate::reference::shape::{
    CYLINDER_BASE, CYLINDER_SIDE, CYLINDER_TOP, Cylinder, cylinder_frame,
};

const PI: f64 = std::f64::consts::PI;

/// The areas that are sampled from a point, given in the cylinder's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderArea<F> {
    pub side: F,
    pub base: F,
    pub top: F,
    /// The point sees no part from outside: it is inside, or on the surface.
    pub inside: bool,
}

/// From outside, the caps that show their front, and from next to the cylinder the half of the side that faces the
/// point; from inside, everything.
pub fn cylinder_area<F: Real>(p: Vec3<F>, radius: F, height: F) -> CylinderArea<F> {
    let beside = radius < (p.x * p.x + p.y * p.y).sqrt();
    let below = p.z < F::zero();
    let above = height < p.z;
    let inside = !beside && !below && !above;
    let half_side = F::new(PI) * radius * height;
    let cap = F::new(PI) * radius * radius;
    CylinderArea {
        side: if inside {
            half_side + half_side
        } else if beside {
            half_side
        } else {
            F::zero()
        },
        base: if inside || below { cap } else { F::zero() },
        top: if inside || above { cap } else { F::zero() },
        inside,
    }
}

/// A point uniform over the areas of `cylinder_area`; the part is chosen by `u24` < 2²⁴.
///
/// Next to the cylinder, a point of that half may still show its back; it yields no sample: pdf 0.
pub fn cylinder_light_sample<F: Real>(
    p: Vec3<F>,
    cylinder: &Cylinder<F>,
    u24: u32,
    u: [F; 2],
) -> LightSample<F> {
    let frame = cylinder_frame(cylinder);
    let pl = to_local(frame, p - cylinder.base);
    let area = cylinder_area(pl, cylinder.radius, cylinder.height);
    let total = area.side + area.base + area.top;
    let choice = choice_below(u24, total);
    let on_side = choice < area.side;
    let on_base = choice < area.side + area.base;
    let half_turn = on_side && !area.inside;
    let (sin, cos) = F::sincos_2pi(if half_turn { u[0] * F::new(0.5) } else { u[0] });
    // Half a turn about the direction to p, or a whole turn.
    let rho = if half_turn {
        (pl.x * pl.x + pl.y * pl.y).sqrt()
    } else {
        F::one()
    };
    let ex = if half_turn { pl.x / rho } else { F::one() };
    let ey = if half_turn { pl.y / rho } else { F::zero() };
    let x = ex * sin - ey * cos;
    let y = ey * sin + ex * cos;
    let r = if on_side {
        cylinder.radius
    } else {
        cylinder.radius * u[1].sqrt()
    };
    let cap_z = if on_base { F::zero() } else { cylinder.height };
    let z = if on_side {
        cylinder.height * u[1]
    } else {
        cap_z
    };
    let n = if on_side {
        vec3(x, y, F::zero())
    } else {
        vec3(F::zero(), F::zero(), F::one())
    };
    let to = vec3(x * r, y * r, z) - pl;
    let turned_away = half_turn && dot3(to, n) >= F::zero();
    let density = if turned_away {
        F::zero()
    } else {
        area_density(total)
    };
    let part = match (on_side, on_base) {
        (true, _) => CYLINDER_SIDE,
        (_, true) => CYLINDER_BASE,
        _ => CYLINDER_TOP,
    };
    let sample = area_sample(to, n, density, part);
    LightSample {
        wi: to_world(frame, sample.wi),
        ..sample
    }
}

/// Density of `cylinder_light_sample` at a point that a path has hit at `distance` with the cosine `cosine` = |N_L·w|.
pub fn cylinder_light_pdf<F: Real>(
    p: Vec3<F>,
    cylinder: &Cylinder<F>,
    distance: F,
    cosine: F,
) -> F {
    let pl = to_local(cylinder_frame(cylinder), p - cylinder.base);
    let area = cylinder_area(pl, cylinder.radius, cylinder.height);
    solid_angle_pdf(
        area_density(area.side + area.base + area.top),
        distance,
        cosine,
    )
}
