//! A thin lens: rays start at points of its disc, and those through one point of the picture meet in the focal plane;
//! twin of `shaders/camera/lens.glsl` and `shaders/camera/lens/`. The formulas: model.md, "The lens".
//!
//! Potmesil & Chakravarty, A Lens and Aperture Camera Model for Synthetic Image Generation, SIGGRAPH 1981; Pharr, Jakob,
//! Humphreys, Physically Based Rendering, 4th edition, section 5.2.3.

use super::eye::{EyeSample, eye_at, eye_sample, picture_point};
use super::pinhole::{Camera, camera_direction};
pub use crate::prepared::record::lens::scalar::Lens;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::SampleId;
use crate::reference::path::blocks::{Origin, path_block};
use crate::reference::sampler::unit_float;
use crate::reference::shape::Ray;
use crate::reference::world::World;
use crate::settings::Settings;

/// A point of the unit disc, uniform by area for uniform `u`.
///
/// Shirley & Chiu, A Low Distortion Map Between Disk and Square, JGT 2(3), 1997: a square of half the side s about the
/// middle becomes the circle of radius s.
pub fn disc_point<F: Real>(u: [F; 2]) -> [F; 2] {
    let (zero, one, two) = (F::zero(), F::one(), F::new(2.0));
    let [a, b] = u.map(|u| two * u - one);
    let wide = a.abs() > b.abs();
    let s = if wide { a } else { b };
    // The angle from the axis of s, π/4 · ratio, is an eighth of a turn at most.
    let ratio = if wide { b } else { a } / if s != zero { s } else { one };
    let (sin_phi, cos_phi) = F::sincos_2pi(ratio.abs() * F::new(0.125));
    let along = s * cos_phi;
    let across = s * if ratio < zero { -sin_phi } else { sin_phi };
    if wide {
        [along, across]
    } else {
        [across, along]
    }
}

/// The point `q` of the lens in space.
pub fn lens_point<F: Real>(camera: &Camera<F>, lens: &Lens<F>, q: [F; 2]) -> Vec3<F> {
    camera.eye + (lens.right * q[0] + lens.up * q[1])
}

/// The point of the pixel through which a pinhole's ray has the direction of the ray from the lens's point `q` through
/// the point `at`. F d1 − l has the direction of d1 − l/F, where d1 is the pinhole's direction to the plane at distance
/// 1, l the lens's point and F the focal distance.
pub fn lens_pixel<F: Real>(lens: &Lens<F>, q: [F; 2], at: [F; 2]) -> [F; 2] {
    [at[0] - q[0] * lens.blur, at[1] - q[1] * lens.blur]
}

/// The lens's point `q` from the point `p`.
///
/// Light that arrives there counts like light that arrives at a pinhole there: the pixel's area A in the plane at the
/// distance F is A F², and the density of its directions per solid angle F²/(A F² cos³). The density of the point on
/// the lens's area cancels, because eye paths start at each point with the density with which it is drawn here.
pub fn lens_sample<F: Real>(
    camera: &Camera<F>,
    lens: &Lens<F>,
    q: [F; 2],
    p: Vec3<F>,
) -> EyeSample<F> {
    let to = p - lens_point(camera, lens, q);
    let [x, y] = picture_point(camera, to);
    eye_at(camera, to, [x + q[0] * lens.blur, y + q[1] * lens.blur])
}

/// The eye that the point `p` sees: for a lens, a point drawn by the numbers of `block` among those of the light path.
pub fn eye_drawn<F: Real>(
    world: &World<F>,
    settings: &Settings,
    id: SampleId,
    block: u32,
    p: Vec3<F>,
) -> EyeSample<F> {
    let Some(lens) = &world.lens else {
        return eye_sample(&world.camera, p);
    };
    let [.., u, v] = id.words(settings, path_block(Origin::Light, block));
    let q = disc_point([unit_float(u), unit_float(v)]);
    lens_sample(&world.camera, lens, q, p)
}

/// The ray from the eye through a point of the pixel, by the random words `u`.
pub fn camera_ray<F: Real>(world: &World<F>, id: SampleId, u: [u32; 4]) -> Ray<F> {
    let camera = &world.camera;
    let [x, y, u, v] = u.map(unit_float);
    let (o, [x, y]) = match &world.lens {
        None => (camera.eye, [x, y]),
        Some(lens) => {
            let q = disc_point([u, v]);
            (lens_point(camera, lens, q), lens_pixel(lens, q, [x, y]))
        }
    };
    let d = camera_direction(camera, id.column, id.row, x, y);
    Ray {
        medium: world.eye_medium,
        ..Ray::new(o, d)
    }
}
