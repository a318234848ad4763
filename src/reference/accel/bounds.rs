//! Boxes about primitives, taken exactly (in `f64`) from the values that the reference computes with.

use glam::DVec3;

use crate::reference::math::Real;
use crate::reference::shape::{Cuboid, Cylinder, Sphere, Triangle};

/// The box { x : lo ≤ x ≤ hi }.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    pub lo: DVec3,
    pub hi: DVec3,
}

impl Bounds {
    /// The neutral element of [`Bounds::union`].
    pub const EMPTY: Self = Self {
        lo: DVec3::MAX,
        hi: DVec3::MIN,
    };

    /// The box that holds nothing but `p`.
    pub fn point(p: DVec3) -> Self {
        Self { lo: p, hi: p }
    }

    /// The smallest box that holds both.
    pub fn union(self, other: Self) -> Self {
        Self {
            lo: self.lo.min(other.lo),
            hi: self.hi.max(other.hi),
        }
    }

    /// The middle, which does not overflow.
    pub fn centre(self) -> DVec3 {
        self.lo * 0.5 + self.hi * 0.5
    }

    /// Half the surface; 0 if empty.
    pub fn area(self) -> f64 {
        let d = (self.hi - self.lo).max(DVec3::ZERO);
        d.x * d.y + d.y * d.z + d.z * d.x
    }

    /// About a sphere: centre ± radius.
    pub fn of_sphere<F: Real>(s: &Sphere<F>) -> Self {
        let (centre, radius) = (s.centre.f64(), s.radius.f64());
        Self {
            lo: centre - radius,
            hi: centre + radius,
        }
    }

    /// The box itself.
    pub fn of_box<F: Real>(b: &Cuboid<F>) -> Self {
        Self {
            lo: b.lo.f64(),
            hi: b.hi.f64(),
        }
    }

    /// The boxes about the two end discs; a disc of radius r spanned by the unit vectors u and v reaches
    /// r √(uᵢ² + vᵢ²) along axis i.
    pub fn of_cylinder<F: Real>(c: &Cylinder<F>) -> Self {
        let (u, v) = (c.u.f64(), c.v.f64());
        let base = c.base.f64();
        let axis = Self::point(base).union(Self::point(base + c.w.f64() * c.height.f64()));
        let disc = (u * u + v * v).map(f64::sqrt) * c.radius.f64();
        Self {
            lo: axis.lo - disc,
            hi: axis.hi + disc,
        }
    }

    /// About the corners of a triangle.
    pub fn of_triangle<F: Real>(t: &Triangle<F>) -> Self {
        t.v.iter()
            .fold(Self::EMPTY, |all, v| all.union(Self::point(v.f64())))
    }
}
