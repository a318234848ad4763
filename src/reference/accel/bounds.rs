//! Boxes about primitives, taken exactly (in `f64`) from the values that the reference computes with.

use crate::prepared::Bounds;
use crate::reference::math::Real;
use crate::reference::shape::{Cuboid, Cylinder, Sphere, Triangle};

/// About a sphere: centre ± radius.
pub fn of_sphere<F: Real>(s: &Sphere<F>) -> Bounds {
    let (centre, radius) = (s.centre.f64(), s.radius.f64());
    Bounds {
        lo: centre - radius,
        hi: centre + radius,
    }
}

/// The box itself.
pub fn of_box<F: Real>(b: &Cuboid<F>) -> Bounds {
    Bounds {
        lo: b.lo.f64(),
        hi: b.hi.f64(),
    }
}

/// The boxes about the two end discs; a disc of radius r spanned by the unit vectors u and v reaches
/// r √(uᵢ² + vᵢ²) along axis i.
pub fn of_cylinder<F: Real>(c: &Cylinder<F>) -> Bounds {
    let (u, v) = (c.u.f64(), c.v.f64());
    let base = c.base.f64();
    let axis = Bounds::around([base, base + c.w.f64() * c.height.f64()]);
    let disc = (u * u + v * v).map(f64::sqrt) * c.radius.f64();
    Bounds {
        lo: axis.lo - disc,
        hi: axis.hi + disc,
    }
}

/// About the corners of a triangle.
pub fn of_triangle<F: Real>(t: &Triangle<F>) -> Bounds {
    Bounds::around(t.v.map(|v| v.f64()))
}
