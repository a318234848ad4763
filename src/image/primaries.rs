//! The primaries of red, green and blue.

/// CIE xy of red, green, blue and white in ITU-R BT.709 and sRGB (IEC 61966-2-1), which vkpt's numbers refer to.
const SRGB: [[f64; 2]; 4] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06], [0.3127, 0.3290]];

/// Whether primaries and white are sRGB's. Writers differ in the fourth digit of the white.
pub fn are_srgb(red_green_blue_white: [[f64; 2]; 4]) -> bool {
    let given = red_green_blue_white.as_flattened();
    let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-3;
    SRGB.as_flattened().iter().zip(given).all(near)
}
