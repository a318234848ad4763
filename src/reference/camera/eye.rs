//! The eye as a point sees it; twin of `shaders/camera/eye.glsl`.

use super::Camera;
use crate::reference::math::{Real, Vec3, dot3, length3};

/// The way to the eye, and the pixel that looks back.
#[derive(Clone, Copy, Debug)]
pub struct EyeSample<F> {
    /// Towards the eye, of unit length.
    pub wi: Vec3<F>,
    pub distance: F,
    /// The eye sees the point within the picture.
    pub seen: bool,
    pub column: u32,
    /// From the top.
    pub row: u32,
    /// What radiance · cosine at the point adds to the pixel, for one of n_l = width · height light paths:
    /// p_c/(t² n_l), p_c = 1/(A cos³) the density of the pixel's directions per solid angle, A = 4 |right||up|/n_l the
    /// pixel's area on the picture plane at distance 1. With cos = z/t that is t/(4 |right||up| z³).
    pub importance: F,
}

/// The eye from the point `p`.
///
/// Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, section 8.3.2: the importance that a pinhole
/// emits.
pub fn eye_sample<F: Real>(camera: &Camera<F>, p: Vec3<F>) -> EyeSample<F> {
    let (zero, one, half) = (F::zero(), F::one(), F::new(0.5));
    let to = p - camera.eye;
    let distance = length3(to);
    let z = dot3(to, camera.forward);
    let right2 = dot3(camera.right, camera.right);
    let up2 = dot3(camera.up, camera.up);
    let (width, height) = (F::from_u32(camera.width), F::from_u32(camera.height));
    // dx = 2 x/W − 1 and dy = 2 y/H − 1 of the point (x, y) in pixels, from the lower left corner
    let dx = dot3(to, camera.right) / (z * right2);
    let dy = dot3(to, camera.up) / (z * up2);
    let x = (dx + one) * half * width;
    let y = (dy + one) * half * height;
    let seen = z > zero && x >= zero && x < width && y >= zero && y < height;
    let whole = |x: F| if seen { x.to_u32() } else { 0 };
    EyeSample {
        wi: -to / if distance > zero { distance } else { one },
        distance,
        seen,
        column: whole(x),
        row: if seen {
            camera.height - 1 - whole(y)
        } else {
            0
        },
        importance: distance / (F::new(4.0) * (right2 * up2).sqrt() * (z * z * z)),
    }
}
