//! Eight scalars side by side, on which one instruction works: each gets the scalar result, to the bit.

use std::ops::{Mul, Sub};

use wide::{f32x8, f64x8};

/// The number of scalars.
pub const WIDTH: usize = 8;

/// [`WIDTH`] scalars `F`.
pub trait Lanes<F>: Copy + Sub<Output = Self> + Mul<Output = Self> {
    /// From the scalars in order.
    fn new(all: [F; WIDTH]) -> Self;
    /// All are `x`.
    fn splat(x: F) -> Self;
    /// The larger one; either where one is not a number.
    fn max(self, other: Self) -> Self;
    /// The smaller one; either where one is not a number.
    fn min(self, other: Self) -> Self;
    /// Bit i: scalar i is larger than that of `other`.
    fn above(self, other: Self) -> u32;
}

macro_rules! lanes {
    ($scalar:ty, $lanes:ty) => {
        impl Lanes<$scalar> for $lanes {
            #[inline(always)]
            fn new(all: [$scalar; WIDTH]) -> Self {
                Self::from(all)
            }
            #[inline(always)]
            fn splat(x: $scalar) -> Self {
                Self::splat(x)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                self.fast_max(other)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                self.fast_min(other)
            }
            #[inline(always)]
            fn above(self, other: Self) -> u32 {
                self.simd_gt(other).to_bitmask() as u32
            }
        }
    };
}

lanes!(f32, f32x8);
lanes!(f64, f64x8);

/// The positions of a mask's bits, the lowest first.
#[derive(Clone, Copy, Debug)]
pub struct Bits(pub u32);

impl Iterator for Bits {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let i = self.0.trailing_zeros() as usize;
        let bit = (self.0 != 0).then_some(i)?;
        self.0 &= self.0 - 1;
        Some(bit)
    }
}
