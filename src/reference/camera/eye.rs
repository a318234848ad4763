//! The eye as seen from a point; twin of `shaders/camera/eye.glsl`.

use super::Camera;
use crate::reference::math::{Real, Vec3, dot3, length3};

/// The direction to the eye, and the pixel that sees the point.
#[derive(Clone, Copy, Debug)]
pub struct EyeSample<F> {
    /// Towards the eye, of unit length.
    pub wi: Vec3<F>,
    pub distance: F,
    /// The point is within the picture as the eye sees it.
    pub seen: bool,
    pub column: u32,
    /// Counted from the top.
    pub row: u32,
    /// See [`eye_importance`].
    pub importance: F,
}

/// The factor with which radiance · cosine at the point `to` from the eye counts in its pixel, for one of
/// n_l = width · height light paths: p_c/(t² n_l), p_c = 1/(A cos³) the density of the pixel's directions per solid angle,
/// A = 4 |right||up|/n_l the pixel's area on the picture plane at distance 1. With cos = z/t that is t/(4 |right||up| z³).
///
/// Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, section 8.3.2: the importance that a pinhole
/// emits.
pub fn eye_importance<F: Real>(camera: &Camera<F>, to: Vec3<F>) -> F {
    let distance = length3(to);
    let z = dot3(to, camera.forward);
    let right2 = dot3(camera.right, camera.right);
    let up2 = dot3(camera.up, camera.up);
    distance / (F::new(4.0) * (right2 * up2).sqrt() * (z * z * z))
}

/// Where a pinhole sees the point `to` from it: (x, y) in pixels, from the picture's lower left corner.
pub fn picture_point<F: Real>(camera: &Camera<F>, to: Vec3<F>) -> [F; 2] {
    let (one, half) = (F::one(), F::new(0.5));
    let z = dot3(to, camera.forward);
    // dx = 2 x/W − 1 and dy = 2 y/H − 1
    let dx = dot3(to, camera.right) / (z * dot3(camera.right, camera.right));
    let dy = dot3(to, camera.up) / (z * dot3(camera.up, camera.up));
    [
        (dx + one) * half * F::from_u32(camera.width),
        (dy + one) * half * F::from_u32(camera.height),
    ]
}

/// The eye from the point `to` from it, which it sees at the point `at` of the picture.
pub fn eye_at<F: Real>(camera: &Camera<F>, to: Vec3<F>, at: [F; 2]) -> EyeSample<F> {
    let (zero, one) = (F::zero(), F::one());
    let distance = length3(to);
    let (width, height) = (F::from_u32(camera.width), F::from_u32(camera.height));
    let inside = at[0] >= zero && at[0] < width && at[1] >= zero && at[1] < height;
    let seen = dot3(to, camera.forward) > zero && inside;
    let whole = |x: F| if seen { x.to_u32() } else { 0 };
    EyeSample {
        wi: -to / if distance > zero { distance } else { one },
        distance,
        seen,
        column: whole(at[0]),
        row: if seen {
            camera.height - 1 - whole(at[1])
        } else {
            0
        },
        importance: eye_importance(camera, to),
    }
}

/// The eye of a pinhole from the point `p`.
pub fn eye_sample<F: Real>(camera: &Camera<F>, p: Vec3<F>) -> EyeSample<F> {
    let to = p - camera.eye;
    eye_at(camera, to, picture_point(camera, to))
}
