//! Linear sRGB, the opponent space YCxCz and CIELAB.

use std::sync::LazyLock;

use glam::{DMat3, DVec3};

/// Linear sRGB → CIE XYZ for the standard's primaries and D65, in the fractions of FLIP's reference
/// implementation.
static TO_XYZ: LazyLock<DMat3> = LazyLock::new(|| {
    DMat3::from_cols(
        DVec3::new(
            10_135_552.0 / 24_577_794.0,
            2_613_072.0 / 12_288_897.0,
            1_425_312.0 / 73_733_382.0,
        ),
        DVec3::new(
            8_788_810.0 / 24_577_794.0,
            8_788_810.0 / 12_288_897.0,
            8_788_810.0 / 73_733_382.0,
        ),
        DVec3::new(
            4_435_075.0 / 24_577_794.0,
            887_015.0 / 12_288_897.0,
            70_074_185.0 / 73_733_382.0,
        ),
    )
});

static FROM_XYZ: LazyLock<DMat3> = LazyLock::new(|| TO_XYZ.inverse());

/// White: XYZ of RGB (1, 1, 1).
static WHITE: LazyLock<DVec3> = LazyLock::new(|| *TO_XYZ * DVec3::ONE);

/// YCxCz of linear sRGB: a linearised L*a*b*, so that blurring it blurs light (Flohr et al., Model-based halftoning
/// using direct binary search, 1993). White is (100, 0, 0).
pub fn opponent(rgb: [f64; 3]) -> [f64; 3] {
    let DVec3 { x, y, z } = *TO_XYZ * DVec3::from(rgb) / *WHITE;
    // Y_y = 116 Y/Y_n − 16, C_x = 500 (X/X_n − Y/Y_n), C_z = 200 (Y/Y_n − Z/Z_n)
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Linear sRGB of YCxCz, the inverse of [`opponent`].
pub fn rgb([yy, cx, cz]: [f64; 3]) -> [f64; 3] {
    let y = (yy + 16.0) / 116.0;
    let relative = DVec3::new(y + cx / 500.0, y, y - cz / 200.0);
    (*FROM_XYZ * (relative * *WHITE)).to_array()
}

/// CIELAB of linear sRGB.
pub fn lab(rgb: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = (*TO_XYZ * DVec3::from(rgb) / *WHITE)
        .to_array()
        .map(compressed);
    // L* = 116 f(Y/Y_n) − 16, a* = 500 (f(X/X_n) − f(Y/Y_n)), b* = 200 (f(Y/Y_n) − f(Z/Z_n)) (CIE 15)
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// f of CIELAB.
fn compressed(t: f64) -> f64 {
    const DELTA: f64 = 6.0 / 29.0;
    // f(t) = ∛t for t > δ³, t/(3δ²) + 4/29 below, δ = 6/29 (CIE 15)
    if t > DELTA * DELTA * DELTA {
        t.cbrt()
    } else {
        t / (3.0 * DELTA * DELTA) + 4.0 / 29.0
    }
}
