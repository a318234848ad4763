//! Owen scrambling by a hash.

/// Flips each binary digit of a number in [0, 1) or not, by a hash of the digits before it: Owen's nested scrambling
/// (Randomly Permuted (t,m,s)-Nets, 1995), `seed` in place of its random bits. `seed` must itself be well mixed.
///
/// Bit 0 is the first digit after the point. Sums and products carry to later digits only, and an even factor excludes
/// a digit from its own hash. Numbers whose first k digits agree and whose next differ stay so.
///
/// Laine & Karras, Stratified Sampling for Stochastic Transparency, EGSR 2011; Burley, Practical Hash-based
/// Owen Scrambling, JCGT 9(4), 2020; constants of Vegdahl, Building a Better LK Hash, 2021
/// (<https://psychopath.io/post/2021_01_30_building_a_better_lk_hash>).
pub fn owen_scramble(digits: u32, seed: u32) -> u32 {
    let x = digits ^ digits.wrapping_mul(0x3d20adea);
    let x = x.wrapping_add(seed).wrapping_mul((seed >> 16) | 1);
    let x = x ^ x.wrapping_mul(0x05526c56);
    x ^ x.wrapping_mul(0x53a22864)
}
