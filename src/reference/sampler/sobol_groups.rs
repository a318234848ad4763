//! Owen-scrambled Sobol points, four dimensions at a time, in groups of samples that are independent of one another.

use super::owen::owen_scramble;
use super::pcg4d::pcg4d;
use super::sobol_digits::{sobol_digits_1, sobol_digits_2, sobol_digits_3};

/// Hash of a word to a word.
///
/// Wellons, Prospecting for Hash Functions, 2018 (<https://nullprogram.com/blog/2018/07/31/>): lowbias32.
pub fn lowbias32(x: u32) -> u32 {
    let a = (x ^ (x >> 16)).wrapping_mul(0x7feb352d);
    let b = (a ^ (a >> 15)).wrapping_mul(0x846ca68b);
    b ^ (b >> 16)
}

/// Four words for one block of a path, `pixel` = row · width + column of the full picture. Samples whose indices agree in
/// their last `group_bits` binary digits are a group.
///
/// Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020: the index is shuffled, the coordinates are scrambled,
/// separately for each block of each group of samples. The shuffle keeps every run of 2ᵏ samples of a group that starts
/// at a multiple of 2ᵏ together, so that in each dimension one of them lies in each of 2ᵏ equal intervals.
///
/// Words y and z (a diffuse direction) have dimensions 1 and 0, a (0, 2)-sequence; z and w (points of lights,
/// micro-normals) 0 and 2, t ≤ 1; x and y (the pixel) 3 and 1, t ≤ 2.
pub fn sobol_block(
    pixel: u32,
    sample_index: u32,
    group_bits: u32,
    block: u32,
    seed: u32,
) -> [u32; 4] {
    // A kernel computes this hash of pixel and seed once a thread, which makes the hash of the rest a short one.
    let key = pcg4d([pixel, 0, 0, seed]);
    let group = sample_index & ((1 << group_bits) - 1);
    let place = (block << group_bits).wrapping_add(group);
    let shuffle = lowbias32(key[0].wrapping_add(place));
    let product = key.map(|k| (k ^ shuffle).wrapping_mul(0x9e3779b1));
    let scramble = product.map(|p| p ^ (p >> 16));
    let index = owen_scramble((sample_index >> group_bits).reverse_bits(), shuffle).reverse_bits();
    [
        owen_scramble(sobol_digits_3(index), scramble[0]).reverse_bits(),
        owen_scramble(sobol_digits_1(index), scramble[1]).reverse_bits(),
        owen_scramble(index, scramble[2]).reverse_bits(),
        owen_scramble(sobol_digits_2(index), scramble[3]).reverse_bits(),
    ]
}
