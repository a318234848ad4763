//! Boxes of the builder, in `f32` whatever the scalar: half the memory, and none is smaller than what it stands for.

use crate::shape::Bounds;

/// The box { x : lo ≤ x ≤ hi }; empty where `lo` > `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    pub lo: [f32; 3],
    pub hi: [f32; 3],
}

impl Extent {
    /// The neutral element of [`Extent::union`].
    pub const EMPTY: Self = Self {
        lo: [f32::INFINITY; 3],
        hi: [f32::NEG_INFINITY; 3],
    };

    /// The smallest box of `f32` that contains `bounds`.
    pub fn around(bounds: Bounds) -> Self {
        Self {
            lo: bounds.lo.to_array().map(below),
            hi: bounds.hi.to_array().map(|x| -below(-x)),
        }
    }

    /// The box that contains nothing but `p`.
    pub fn point(p: [f32; 3]) -> Self {
        Self { lo: p, hi: p }
    }

    /// The smallest box that contains both.
    #[inline]
    pub fn union(self, other: Self) -> Self {
        let axis = |k: usize| (self.lo[k].min(other.lo[k]), self.hi[k].max(other.hi[k]));
        let [x, y, z] = [axis(0), axis(1), axis(2)];
        Self {
            lo: [x.0, y.0, z.0],
            hi: [x.1, y.1, z.1],
        }
    }

    /// lo + hi
    #[inline]
    pub fn twice_centre(self) -> [f32; 3] {
        [0, 1, 2].map(|k| self.lo[k] + self.hi[k])
    }

    /// Half the surface; 0 if empty.
    pub fn half_area(self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|k| (self.hi[k] - self.lo[k]).max(0.0));
        x * y + y * z + z * x
    }

    /// The largest absolute coordinate.
    pub fn reach(self) -> f32 {
        let largest = |all: f32, x: &f32| all.max(x.abs());
        self.lo.iter().chain(&self.hi).fold(0.0, largest)
    }
}

/// The largest `f32` that is not above `x`.
fn below(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) > x {
        near.next_down()
    } else {
        near
    }
}
