//! Axis-aligned boxes about primitives, from the `f32` values that the kernels compute with.

use crate::shape::Primitive;

/// The box { x : lo ≤ x ≤ hi }.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub lo: [f32; 3],
    pub hi: [f32; 3],
}

impl Bounds {
    /// The neutral element of [`Bounds::union`].
    pub const EMPTY: Self = Self {
        lo: [f32::MAX; 3],
        hi: [f32::MIN; 3],
    };

    /// The smallest `f32` box that holds a primitive as the kernels receive it: each bound is rounded outwards.
    pub fn of(primitive: &dyn Primitive) -> Self {
        let exact = primitive.extent_in_f32();
        Self {
            lo: exact.lo.to_array().map(round_down),
            hi: exact.hi.to_array().map(round_up),
        }
    }

    /// The smallest box that holds both.
    pub fn union(self, other: Self) -> Self {
        Self {
            lo: std::array::from_fn(|k| self.lo[k].min(other.lo[k])),
            hi: std::array::from_fn(|k| self.hi[k].max(other.hi[k])),
        }
    }

    /// Whether `other` lies within.
    pub fn contains(self, other: Self) -> bool {
        (0..3).all(|k| self.lo[k] <= other.lo[k] && other.hi[k] <= self.hi[k])
    }

    /// Of its surface; 0 where it is empty.
    pub fn area(self) -> f64 {
        let [x, y, z] =
            std::array::from_fn(|k| (f64::from(self.hi[k]) - f64::from(self.lo[k])).max(0.0));
        2.0 * (x * y + y * z + z * x)
    }
}

/// The largest `f32` that is not above `x`.
fn round_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

/// The smallest `f32` that is not below `x`.
fn round_up(x: f64) -> f32 {
    -round_down(-x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_round_outwards() {
        let x = 1.0 + 2f64.powi(-30);
        assert_eq!((round_down(x), round_up(x)), (1.0, 1.0 + f32::EPSILON));
        assert_eq!((round_down(-x), round_up(-x)), (-1.0 - f32::EPSILON, -1.0));
        assert_eq!((round_down(0.5), round_up(0.5)), (0.5, 0.5));
    }
}
