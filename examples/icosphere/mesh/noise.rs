//! Value noise (Ebert et al., *Texturing and Modeling*, ch. 2): random values at the points of a lattice, blended
//! smoothly between them.

use glam::DVec3;

const OCTAVES: i32 = 5;

/// Bumps in [−1, 1], twice differentiable: octaves of noise, each half as wide and half as high as the one before.
pub fn fractal(p: DVec3, seed: u64) -> f64 {
    let octave = |k: i32| {
        let scale = 2f64.powi(k);
        noise(p * (2.0 * scale), seed.wrapping_add(k as u64)) / scale
    };
    // 1 + 1/2 + … + 2^(1 − OCTAVES)
    let sum = 2.0 - 2f64.powi(1 - OCTAVES);
    (0..OCTAVES).map(octave).sum::<f64>() / sum
}

/// Noise in [−1, 1] with a value at each point of whole coordinates.
fn noise(p: DVec3, seed: u64) -> f64 {
    let cell = p.floor();
    let t = p - cell;
    // 6t⁵ − 15t⁴ + 10t³ (Perlin, Improving Noise, 2002): its first two derivatives are 0 at 0 and 1.
    let s = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let at = |x: f64, y: f64, z: f64| value(cell + DVec3::new(x, y, z), seed);
    let blend = |a: f64, b: f64, s: f64| a + s * (b - a);
    let along_x = |y, z| blend(at(0.0, y, z), at(1.0, y, z), s.x);
    let along_y = |z| blend(along_x(0.0, z), along_x(1.0, z), s.y);
    blend(along_y(0.0), along_y(1.0), s.z)
}

/// The value in [−1, 1) at a point of the lattice.
fn value(point: DVec3, seed: u64) -> f64 {
    let bits = point.to_array().into_iter().fold(seed, |state, x| {
        mix(state.wrapping_add(0x9e37_79b9_7f4a_7c15) ^ (x as i64 as u64))
    });
    (bits >> 11) as f64 * 2f64.powi(-52) - 1.0
}

/// The output function of SplitMix64 (Steele, Lea, Flood 2014).
fn mix(z: u64) -> u64 {
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
