//! The direction in which a light path starts: half of them about the light's normal, half at objects that gather
//! light; twin of `shaders/integrator/bidirectional/aim/`.

use crate::reference::bsdf::diffuse::lambert::cosine_lobe;
use crate::reference::light::sphere::{cone_direction, cone_height, cone_pdf};
use crate::reference::math::frame::{frame_about, to_world};
use crate::reference::math::{Real, Vec3, dot3, length3};
use crate::reference::world::Aim;

/// A direction from the point `p` of a light with normal `n`: one in two within the cone of an aim, each as likely;
/// `choice` and `u` are uniform. From inside a ball, and without aims, cos θ/π.
pub fn aimed_direction<F: Real>(
    aims: &[Aim<F>],
    p: Vec3<F>,
    n: Vec3<F>,
    choice: F,
    u: [F; 2],
) -> Vec3<F> {
    let place = (choice * F::from_u32(2 * aims.len() as u32)).to_u32() as usize;
    if let Some(aim) = aims.get(place) {
        let axis = aim.centre - p;
        let distance = length3(axis);
        if distance > aim.radius {
            let height = cone_height(aim.radius, distance);
            return to_world(frame_about(axis / distance), cone_direction(height, u));
        }
    }
    to_world(frame_about(n), cosine_lobe(u))
}

/// Density of that direction per solid angle, over its cosine at the light.
pub fn aimed_density<F: Real>(aims: &[Aim<F>], p: Vec3<F>, d: Vec3<F>, cosine: F) -> F {
    let lobe = F::new(std::f64::consts::FRAC_1_PI);
    if aims.is_empty() {
        return lobe;
    }
    let mut sum = F::zero();
    for aim in aims {
        let axis = aim.centre - p;
        let distance = length3(axis);
        if distance > aim.radius {
            let height = cone_height(aim.radius, distance);
            // 1 − cos = |d − axis|²/2, which loses no digit of a narrow cone.
            let off = d - axis / distance;
            let within = dot3(off, off) * F::new(0.5) <= height;
            sum += if within {
                cone_pdf(height) / cosine
            } else {
                F::zero()
            };
        } else {
            sum += lobe;
        }
    }
    (lobe + sum / F::from_u32(aims.len() as u32)) * F::new(0.5)
}
