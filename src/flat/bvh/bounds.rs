//! Axis-aligned boxes about primitives, from the `f32` values that the kernels compute with.

use glam::DVec3;

use crate::prepared::{Cuboid, Cylinder, Sphere, Triangle};

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

    /// The smallest `f32` box that holds both points: each bound is rounded outwards.
    fn spanning(lo: DVec3, hi: DVec3) -> Self {
        Self {
            lo: lo.to_array().map(round_down),
            hi: hi.to_array().map(round_up),
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

    pub fn of_triangle(triangle: &Triangle) -> Self {
        let [a, b, c] = triangle.v.map(rounded);
        Self::spanning(a.min(b).min(c), a.max(b).max(c))
    }

    /// centre ± radius
    pub fn of_sphere(sphere: &Sphere) -> Self {
        let (centre, radius) = (rounded(sphere.centre), sphere.radius as f32 as f64);
        Self::spanning(centre - radius, centre + radius)
    }

    pub fn of_box(cuboid: &Cuboid) -> Self {
        Self::spanning(rounded(cuboid.lo), rounded(cuboid.hi))
    }

    /// The boxes about the two end discs: a disc of radius r spanned by the unit vectors u and v reaches
    /// r √(uᵢ² + vᵢ²) along axis i.
    pub fn of_cylinder(cylinder: &Cylinder) -> Self {
        let [base, u, v, w] = [cylinder.base, cylinder.u, cylinder.v, cylinder.w].map(rounded);
        let top = base + w * (cylinder.height as f32 as f64);
        let disc = (u * u + v * v).map(f64::sqrt) * (cylinder.radius as f32 as f64);
        Self::spanning(base.min(top) - disc, base.max(top) + disc)
    }
}

/// Each component rounded to the nearest `f32`, as the kernels receive it.
fn rounded(v: DVec3) -> DVec3 {
    v.as_vec3().as_dvec3()
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

    /// A tilted cylinder: points of its rims, taken on a fine grid, fill the box to within the grid.
    #[test]
    fn cylinder_bounds_are_tight() {
        let w = DVec3::new(1.0, 2.0, 2.0) / 3.0;
        let u = DVec3::new(2.0, 1.0, -2.0) / 3.0;
        let cylinder = Cylinder {
            base: DVec3::new(0.3, -0.2, 5.0),
            u,
            v: w.cross(u),
            w,
            height: 2.5,
            radius: 0.75,
            shape: 0,
        };
        let bounds = Bounds::of_cylinder(&cylinder);
        let mut seen = Bounds::EMPTY;
        for k in 0..100_000 {
            let (s, c) = (f64::from(k) * 1e-5 * std::f64::consts::TAU).sin_cos();
            let rim = cylinder.base + (u * c + cylinder.v * s) * cylinder.radius;
            seen = seen.union(Bounds::spanning(rim, rim + w * cylinder.height));
        }
        for k in 0..3 {
            assert!((bounds.lo[k] - seen.lo[k]).abs() < 1e-5, "axis {k}");
            assert!((bounds.hi[k] - seen.hi[k]).abs() < 1e-5, "axis {k}");
        }
    }
}
