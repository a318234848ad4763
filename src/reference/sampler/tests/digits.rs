//! Digits and scrambling compared with another implementation and with published direction numbers.

use sobol_burley::parts::{owen_scramble_rev, sobol_rev};

use super::super::owen::owen_scramble;
use super::super::random;
use super::super::sobol_digits::{sobol_digits_1, sobol_digits_2, sobol_digits_3};

type Digits = fn(u32) -> u32;

/// The four dimensions.
pub const DIGITS: [Digits; 4] = [
    |index| index,
    sobol_digits_1,
    sobol_digits_2,
    sobol_digits_3,
];

/// `sobol_burley` has the table of Joe & Kuo, for indices below 2¹⁶, both sides with their digits reversed.
#[test]
fn the_digits_are_those_of_sobol_burley() {
    for (digits, dimension) in DIGITS.iter().zip(0..) {
        for index in 0..1u32 << 16 {
            let theirs = sobol_rev(index.reverse_bits(), dimension);
            assert_eq!(digits(index), theirs, "dimension {dimension}, {index}");
        }
    }
}

/// Rows d = 2, 3, 4 of `new-joe-kuo-6.21201`: degree s, coefficients a, first direction numbers m.
const JOE_KUO: [(usize, u64, &[u64]); 3] = [(1, 0, &[1]), (2, 1, &[1, 3]), (3, 1, &[1, 3, 1])];

/// mₖ = 2 a₁ mₖ₋₁ ⊕ … ⊕ 2ˢ⁻¹ aₛ₋₁ mₖ₋ₛ₊₁ ⊕ 2ˢ mₖ₋ₛ ⊕ mₖ₋ₛ (Joe & Kuo, Notes on generating Sobol'
/// sequences, 2008), as the 32 digits of mₖ / 2ᵏ from the first on.
fn direction_numbers((s, a, first): (usize, u64, &[u64])) -> [u32; 32] {
    let mut m = first.to_vec();
    for k in s..32 {
        let middle = (1..s).filter(|i| a >> (s - 1 - i) & 1 == 1);
        let middle = middle.fold(0, |sum, i| sum ^ (m[k - i] << i));
        m.push(middle ^ (m[k - s] << s) ^ m[k - s]);
    }
    let digits = |k: usize| ((m[k] << (31 - k)) as u32).reverse_bits();
    std::array::from_fn(digits)
}

/// Every bit of the index alone; and they add.
#[test]
fn the_digits_are_those_of_joe_and_kuos_direction_numbers() {
    for (row, digits) in JOE_KUO.into_iter().zip(&DIGITS[1..]) {
        let v = direction_numbers(row);
        for (k, v) in v.iter().enumerate() {
            assert_eq!(digits(1 << k), *v, "{row:?}, bit {k}");
        }
        for i in 0..1000 {
            let [a, b, ..] = random::sampler_block(0, i, 0, 0);
            assert_eq!(digits(a ^ b), digits(a) ^ digits(b));
        }
    }
}

/// The recurrence with another polynomial makes another sequence.
#[test]
fn a_wrong_polynomial_is_noticed() {
    let wrong = direction_numbers((3, 2, &[1, 3, 1]));
    let differ = (0..32).filter(|&k| sobol_digits_3(1 << k) != wrong[k]);
    assert!(differ.count() > 20);
}

#[test]
fn the_scrambling_is_that_of_sobol_burley() {
    for i in 0..10_000 {
        let [x, seed, ..] = random::sampler_block(1, i, 0, 0);
        assert_eq!(owen_scramble(x, seed), owen_scramble_rev(x, seed));
    }
}

/// How many first digits of two numbers agree.
fn common(a: u32, b: u32) -> u32 {
    (a ^ b).trailing_zeros()
}

/// Whether a scrambling with this seed keeps the number of first digits in which a and b agree.
fn nested(scramble: fn(u32, u32) -> u32, a: u32, b: u32, seed: u32) -> bool {
    common(scramble(a, seed), scramble(b, seed)) == common(a, b)
}

/// Owen's property: a digit is flipped only by those before it. Checked from every number of common digits.
#[test]
fn scrambling_keeps_common_digits() {
    let right_shift: fn(u32, u32) -> u32 = |x, seed| owen_scramble(x ^ (x >> 9), seed);
    let mut noticed = 0;
    for i in 0..1000 {
        let [a, rest, seed, _] = random::sampler_block(2, i, 0, 0);
        for k in 0..32 {
            let b = a ^ (1 << k) ^ ((rest << k) << 1);
            assert_eq!(common(a, b), k);
            assert!(nested(owen_scramble, a, b, seed), "{a:#x}, {b:#x}");
            noticed += u32::from(!nested(right_shift, a, b, seed));
        }
    }
    assert!(noticed > 10_000, "the planted error shows {noticed} times");
}
