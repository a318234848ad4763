//! Axis-aligned boxes as lights; twin of `shaders/light/box.glsl`.

use super::sample::{LightSample, area_density, area_sample, choice_below, solid_angle_pdf};
use crate::reference::math::{Real, Vec3, vec3};

/// The number of faces across each axis that are sampled from `p`, 0 to 2: from outside those that show their front, at
/// most one an axis; from inside, or from a point on the box that sees none, all six.
pub fn faces_seen<F: Real>(p: Vec3<F>, lo: Vec3<F>, hi: Vec3<F>) -> Vec3<F> {
    let seen = |p: F, lo: F, hi: F| {
        if p < lo || hi < p {
            F::one()
        } else {
            F::zero()
        }
    };
    let faces = vec3(
        seen(p.x, lo.x, hi.x),
        seen(p.y, lo.y, hi.y),
        seen(p.z, lo.z, hi.z),
    );
    if faces.is_zero() {
        Vec3::splat(F::new(2.0))
    } else {
        faces
    }
}

/// The area of one face across each axis.
pub fn face_areas<F: Real>(e: Vec3<F>) -> Vec3<F> {
    vec3(e.y * e.z, e.z * e.x, e.x * e.y)
}

/// Whether the upper face across an axis is chosen: the one that shows its front, or if both are sampled, the one that
/// the second half of the choice selects.
pub fn upper_face<F: Real>(p: F, lo: F, faces: F, area: F, choice: F) -> bool {
    if faces == F::one() {
        lo <= p
    } else {
        area <= choice
    }
}

/// A point uniform over the faces that `p` sees; the face is chosen by `u24` < 2²⁴.
pub fn box_light_sample<F: Real>(
    p: Vec3<F>,
    lo: Vec3<F>,
    hi: Vec3<F>,
    u24: u32,
    u: [F; 2],
) -> LightSample<F> {
    let e = hi - lo;
    let faces = faces_seen(p, lo, hi);
    let face = face_areas(e);
    let area = faces * face;
    let total = area.x + area.y + area.z;
    let choice = choice_below(u24, total);
    let x = choice < area.x;
    let y = !x && choice < area.x + area.y;
    let z = !x && !y;
    let unit = |on: bool| if on { F::one() } else { F::zero() };
    let upper_x = unit(upper_face(p.x, lo.x, faces.x, face.x, choice));
    let upper_y = unit(upper_face(p.y, lo.y, faces.y, face.y, choice - area.x));
    let upper_z = unit(upper_face(
        p.z,
        lo.z,
        faces.z,
        face.z,
        choice - (area.x + area.y),
    ));
    let across = if x { u[0] } else { u[1] };
    let at = vec3(
        if x { upper_x } else { u[0] },
        if y { upper_y } else { across },
        if z { upper_z } else { u[1] },
    );
    let (axis, upper) = match (x, y) {
        (true, _) => (0, upper_x),
        (_, true) => (1, upper_y),
        _ => (2, upper_z),
    };
    let n = vec3(unit(x), unit(y), unit(z));
    let face = 2 * axis + u32::from(upper == F::one());
    area_sample(lo + e * at - p, n, area_density(total), face)
}

/// Density of `box_light_sample` at a point that a path has hit at `distance` with the cosine `cosine` = |N_L·w|.
pub fn box_light_pdf<F: Real>(p: Vec3<F>, lo: Vec3<F>, hi: Vec3<F>, distance: F, cosine: F) -> F {
    let area = faces_seen(p, lo, hi) * face_areas(hi - lo);
    let total = area.x + area.y + area.z;
    solid_angle_pdf(area_density(total), distance, cosine)
}
