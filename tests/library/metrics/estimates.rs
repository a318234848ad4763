//! Pictures with and without standard errors, as the block z-test takes them.

use vkpt::film::Film;
use vkpt::image::Precision;
use vkpt::metrics::StandardErrors;
use vkpt::metrics::blocks::{ALPHA, BlockTest, Estimate, Stderr, z_test};

pub fn measured<'a>(mean: &'a Film, stderr: &'a Film) -> Estimate<'a> {
    Estimate {
        mean,
        stderr: Stderr::PerPixel(StandardErrors::exact(stderr)),
        precision: Precision::Single,
    }
}

pub fn exact(mean: &Film) -> Estimate<'_> {
    Estimate {
        mean,
        stderr: Stderr::Exact,
        precision: Precision::Single,
    }
}

pub fn test(a: &Estimate, b: &Estimate) -> BlockTest {
    z_test(a, b, ALPHA).expect("two pictures")
}
