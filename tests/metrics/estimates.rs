//! Pictures with and without standard errors, as the block z-test takes them.

use vkpt::film::Film;
use vkpt::metrics::blocks::{ALPHA, BlockTest, Estimate, Rounding, Stderr, z_test};

/// The unit of rounding of f32, 2⁻²⁴.
const F32: Rounding = Rounding {
    relative: 0.5 * f32::EPSILON as f64,
    absolute: 0.0,
};

pub fn measured<'a>(mean: &'a Film, stderr: &'a Film) -> Estimate<'a> {
    Estimate {
        mean,
        stderr: Stderr::PerPixel(stderr),
        rounding: F32,
    }
}

pub fn exact(mean: &Film) -> Estimate<'_> {
    Estimate {
        mean,
        stderr: Stderr::Exact,
        rounding: F32,
    }
}

pub fn test(a: &Estimate, b: &Estimate) -> BlockTest {
    z_test(a, b, ALPHA).expect("two pictures")
}
