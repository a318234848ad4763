//! Differences of products without cancellation; twin of `shaders/math/products.glsl`.

use super::real::Real;

/// A number as the sum of two with half as many bits each.
#[derive(Clone, Copy, Debug)]
pub struct Halves<F> {
    pub hi: F,
    pub lo: F,
}

/// a = hi + lo, exactly. Dekker, A Floating-Point Technique for Extending the Available Precision, Numerische
/// Mathematik 18, 1971 (Veltkamp's splitting).
pub fn halves<F: Real>(a: F) -> Halves<F> {
    let c = F::SPLIT * a;
    let hi = c - (c - a);
    Halves { hi, lo: a - hi }
}

/// a b − p, exactly, where p is a b rounded (Dekker 1971).
pub fn product_error<F: Real>(a: Halves<F>, b: Halves<F>, p: F) -> F {
    a.lo * b.lo - (p - a.hi * b.hi - a.lo * b.hi - a.hi * b.lo)
}

/// a b − c d, with a relative error of at most 2u + O(u²), u half an ulp of 1: the sign is always right, and 0
/// only if the products are equal. Exchanging the products negates it exactly.
///
/// Cornea, Harrison, Tang, Scientific Computing on Itanium-based Systems, 2002; the bound: Jeannerod, A
/// Radix-Independent Error Analysis of the Cornea–Harrison–Tang Method, ACM TOMS 42(3), 2016. Holds in `f32` for
/// products that are 0 or of a size within 1e-28 … 1e30, so that their errors do not underflow and no half
/// overflows.
pub fn difference_of_products<F: Real>(a: F, b: F, c: F, d: F) -> F {
    let p = a * b;
    let q = c * d;
    let ep = product_error(halves(a), halves(b), p);
    let eq = product_error(halves(c), halves(d), q);
    (p - q) + (ep - eq)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In `f64`, products of `f32` are exact, and so is the sign of their difference; it is rounded once.
    #[test]
    fn f32_is_within_two_half_ulps_of_f64() {
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state
        };
        for i in 0..1_000_000 {
            let mut near_one = || 1.0 + (next() >> 9) as f32 * f32::EPSILON;
            let (a, b) = (near_one(), near_one());
            // Unrelated factors and ones of nearly the same product, alternating.
            let c = if i % 2 == 0 { near_one() } else { a.next_up() };
            let d = if i % 2 == 0 {
                near_one()
            } else {
                b.next_down()
            };
            let exact = f64::from(a) * f64::from(b) - f64::from(c) * f64::from(d);
            let error = (f64::from(difference_of_products(a, b, c, d)) - exact).abs();
            assert!(
                error <= 2.0 * f64::from(f32::ULP) * exact.abs(),
                "{a} {b} {c} {d}"
            );
            let swapped = difference_of_products(c, d, a, b);
            assert_eq!(swapped, -difference_of_products(a, b, c, d));
        }
    }
}
