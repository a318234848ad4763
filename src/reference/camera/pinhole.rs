//! A pinhole: all rays start at the eye.

pub use crate::prepared::record::camera::scalar::Camera;
use crate::reference::math::{Real, Vec3, normalize3};

/// Unit direction of the ray through the point (a, b) of the pixel in column `x` and row `y`, row 0 at the top.
///
/// (a, b) lies in [0, 1)², (0, 0) is the pixel's lower left corner: uniform numbers make a box filter one pixel wide.
/// For fewer than 2²⁴ pixels a side.
pub fn camera_direction<F: Real>(camera: &Camera<F>, x: u32, y: u32, a: F, b: F) -> Vec3<F> {
    let (two, one) = (F::new(2.0), F::one());
    let row = camera.height - 1 - y;
    // dx = 2 (x + a) / W − 1, dy = 2 (H − 1 − y + b) / H − 1
    let dx = two * (F::from_u32(x) + a) / F::from_u32(camera.width) - one;
    let dy = two * (F::from_u32(row) + b) / F::from_u32(camera.height) - one;
    normalize3(camera.forward + camera.right * dx + camera.up * dy)
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::*;

    const WIDTH: u32 = 640;
    const HEIGHT: u32 = 480;
    const RY: f64 = 0.75;
    const RX: f64 = RY * WIDTH as f64 / HEIGHT as f64;

    /// A camera that looks along the third column of `axes`, negated.
    fn camera<F: Real>(axes: DMat3) -> Camera<F> {
        Camera {
            eye: Vec3::zero(),
            right: Vec3::new(axes.x_axis * RX),
            up: Vec3::new(axes.y_axis * RY),
            forward: Vec3::new(-axes.z_axis),
            width: WIDTH,
            height: HEIGHT,
        }
    }

    /// The direction by angles: azimuth and elevation have the tangents that similar triangles give.
    fn by_angles(axes: DMat3, column: f64, row_from_below: f64) -> DVec3 {
        let azimuth = (RX * (2.0 * column / f64::from(WIDTH) - 1.0)).atan();
        let elevation =
            (RY * (2.0 * row_from_below / f64::from(HEIGHT) - 1.0) * azimuth.cos()).atan();
        let (sin_a, cos_a) = azimuth.sin_cos();
        let (sin_e, cos_e) = elevation.sin_cos();
        axes * DVec3::new(cos_e * sin_a, sin_e, -cos_e * cos_a)
    }

    /// Largest distance of the camera's directions from those by angles over a grid of pixels.
    fn departure<F: Real>(camera: &Camera<F>, axes: DMat3) -> f64 {
        let mut worst = 0.0f64;
        for (x, y) in (0..WIDTH)
            .step_by(9)
            .flat_map(|x| (0..HEIGHT).step_by(7).map(move |y| (x, y)))
        {
            for (a, b) in [(0.0, 0.0), (0.25, 0.875), (1.0 - 2f64.powi(-24), 0.5)] {
                let d = camera_direction(camera, x, y, F::new(a), F::new(b));
                let truth = by_angles(axes, f64::from(x) + a, f64::from(HEIGHT - 1 - y) + b);
                worst = worst.max((d.f64() - truth).length());
            }
        }
        worst
    }

    /// dx and dy have two roundings of a number below 2 and one of a number below 1: 2⁻²² + 2⁻²⁵ each;
    /// the sum and its normalisation a handful of 2⁻²⁴.
    const BOUND: f64 = (RX + RY) * 2.7e-7 + 8.0 * 6e-8;

    #[test]
    fn directions_agree_with_angles() {
        let turned = DMat3::from_rotation_z(0.3)
            * DMat3::from_rotation_x(1.1)
            * DMat3::from_rotation_y(-2.0);
        for axes in [DMat3::IDENTITY, turned] {
            assert!(departure(&camera::<f64>(axes), axes) < 1e-14);
            assert!(departure(&camera::<f32>(axes), axes) < BOUND);
        }
    }

    #[test]
    fn a_shift_of_a_hundredth_pixel_and_a_flip_are_noticed() {
        let axes = DMat3::IDENTITY;
        let mut shifted = camera::<f32>(axes);
        shifted.forward += shifted.right * (0.02 / WIDTH as f32);
        assert!(departure(&shifted, axes) > BOUND);
        let mut flipped = camera::<f32>(axes);
        flipped.up = -flipped.up;
        assert!(departure(&flipped, axes) > BOUND);
    }
}
