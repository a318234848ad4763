//! Sobol's sequence in four dimensions, without tables.
//!
//! Bit 0 is the first binary digit after the point of a coordinate, and the last one of the index: dimension 0, the
//! radical inverse, has the digits of the index itself.
//!
//! Let the index be a polynomial over GF(2), bit k the coefficient of xᵏ. Sobol's direction numbers of a primitive
//! polynomial p of degree e obey (vₖ: digits by which bit k of the index changes the coordinate; Bratley & Fox,
//! Algorithm 659, ACM TOMS 14, 1988)
//!
//! vₖ = a₁ vₖ₋₁ ⊕ … ⊕ aₑ₋₁ vₖ₋ₑ₊₁ ⊕ vₖ₋ₑ ⊕ (vₖ₋ₑ shifted by e digits),  p = xᵉ + a₁ xᵉ⁻¹ + … + aₑ₋₁ x + 1,
//!
//! that is p(E) v = v shifted by e digits, E the step from k to k + 1. The remainder of xᵏ by p, as a function of k,
//! obeys p(E) r = 0, and the quotient p(E) q = xᵏ. So the digits of a coordinate, e at a time, are those of the index in base
//! p, up to one linear map of e digits, the same everywhere, which the first numbers m₁ … mₑ decide.
//!
//! The digits in base p come by halving: over GF(2) p(x)ʰ = p(xʰ) where h is a power of two, three terms. Quotient and
//! remainder by p⁸ are in the upper and lower half; both are divided by p⁴ at once, all four by p², and so on.
//!
//! p and m are those of Joe & Kuo, Constructing Sobol' Sequences with Better Two-Dimensional Projections, SIAM J. Sci.
//! Comput. 30, 2008 (`new-joe-kuo-6`, d = 2, 3, 4).

/// Dimension 1: p = x + 1, the matrix of Pascal's triangle modulo 2.
pub fn sobol_digits_1(index: u32) -> u32 {
    // by p¹⁶ = x¹⁶ + 1, p⁸, p⁴, p², p: the quotient q of q x¹⁶ + r is q, the remainder r ⊕ q
    let mut x = index ^ (index >> 16);
    x ^= (x >> 8) & 0x00ff00ff;
    x ^= (x >> 4) & 0x0f0f0f0f;
    x ^= (x >> 2) & 0x33333333;
    x ^ ((x >> 1) & 0x55555555)
}

/// Dimension 2: p = x² + x + 1, m = 1, 3.
pub fn sobol_digits_2(index: u32) -> u32 {
    // d c b a, of h bits each, by pʰ = x²ʰ + xʰ + 1: quotient d, c ⊕ d, remainder b ⊕ c, a ⊕ (c ⊕ d); h = 8
    let mut x = index ^ ((index >> 8) & 0x00ffff00);
    x ^= (x >> 16) & 0x000000ff;
    // h = 4
    x ^= (x >> 4) & 0x0ff00ff0;
    x ^= (x >> 8) & 0x000f000f;
    // h = 2
    x ^= (x >> 2) & 0x3c3c3c3c;
    x ^= (x >> 4) & 0x03030303;
    // h = 1, and by m every second digit added to the one before: d, c, b ⊕ c, a ⊕ b ⊕ d
    x ^ ((x >> 1) & 0x33333333) ^ ((x >> 3) & 0x11111111)
}

/// Dimension 3: p = x³ + x + 1, m = 1, 3, 1.
pub fn sobol_digits_3(index: u32) -> u32 {
    // f e d c b a, of h bits each, by pʰ = x³ʰ + xʰ + 1: quotient f, e, d' = d ⊕ f, remainder c ⊕ e ⊕ f, b ⊕ e ⊕ d',
    // a ⊕ d'; h = 8, where f and e are beyond the word
    let mut x = index ^ (index >> 24) ^ ((index >> 16) & 0x0000ff00);
    // h = 4: d and c take f and e, then c, b, a take f, e, d', and b takes d'
    x ^= (x >> 8) & 0x0000ff00;
    x ^= ((x >> 12) & 0x00000fff) ^ ((x >> 8) & 0x000000f0);
    // h = 2
    x ^= (x >> 4) & 0xf00f00f0;
    x ^= ((x >> 6) & 0x3f03f03f) ^ ((x >> 4) & 0x0c00c00c);
    // h = 1
    x ^= (x >> 2) & 0x0c30c30c;
    x ^= ((x >> 3) & 0x071c71c7) ^ ((x >> 2) & 0x02082082);
    // by m, the second of three digits added to the first
    x ^ ((x >> 1) & 0x49249249)
}
