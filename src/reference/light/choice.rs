//! Choice from a table of counts out of 2²⁴; twin of `shaders/light/choice/` and of the choice in
//! `shaders/light/mesh.glsl`.

use crate::reference::math::Real;

/// The i with `cdf[i]` ≤ `u24` < `cdf[i + 1]`, for `u24` < 2²⁴ (see `prepared::cdf`). Entries of no width are
/// never chosen.
pub fn cdf_choice(cdf: &[u32], u24: u32) -> u32 {
    let mut low = 0;
    let mut high = cdf.len() as u32 - 1;
    while high - low > 1 {
        let middle = (low + high) / 2;
        if cdf[middle as usize] <= u24 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// The probability of entry i, exact in f32.
pub fn cdf_probability<F: Real>(cdf: &[u32], i: u32) -> F {
    F::from_u32(cdf[i as usize + 1] - cdf[i as usize]) * F::new(1.0 / 16_777_216.0)
}
