//! Coincident faces: which of them counts (model.md, "Coincident faces"); twin of `shaders/shape/cover/`.

use super::ray::{Hit, Ray, START_OUTSIDE};
use crate::prepared::NONE;
use crate::reference::math::{Real, Vec3};
use crate::reference::primitives::Primitives;

/// Decides whether a hit counts in a search for the nearest.
pub trait Cover<F> {
    /// Whether a hit of `ray` with this face does not count: the ray starts on a face that coincides with it, or
    /// another face comes first at this point. Among touching solids, the one that contains the ray comes first: the
    /// ray `enters` the other from air alone.
    fn is_covered(&self, ray: Ray<F>, shape: u32, prim: u32, t: F, enters: bool) -> bool;
}

/// No two faces coincide.
pub struct NoCover;

impl<F> Cover<F> for NoCover {
    #[inline(always)]
    fn is_covered(&self, _: Ray<F>, _: u32, _: u32, _: F, _: bool) -> bool {
        false
    }
}

impl<F: Real> Cover<F> for Primitives<F> {
    fn is_covered(&self, ray: Ray<F>, shape: u32, prim: u32, t: F, enters: bool) -> bool {
        let p = ray.o + ray.d * t;
        self.coincident.of(shape, prim).iter().any(|c| {
            let starts = c.shape == ray.shape && c.prim == ray.prim;
            let first = c.touches == 0 || (enters && ray.medium != NONE);
            starts || (first && self.face_point(c, p).within)
        })
    }
}

/// Whether a face that comes first covers this one at the point `p`.
pub fn is_covered_at<F: Real>(
    primitives: &Primitives<F>,
    shape: u32,
    prim: u32,
    p: Vec3<F>,
) -> bool {
    // The background, which is no shape, has no faces.
    shape != NONE
        && (primitives.coincident.of(shape, prim).iter())
            .any(|c| c.touches == 0 && primitives.face_point(c, p).within)
}

/// The hit of a ray that has left a solid where another touches it: with that one, at once. Elsewhere `best`.
pub fn touching<F: Real>(primitives: &Primitives<F>, ray: Ray<F>, best: Hit<F>) -> Hit<F> {
    if ray.start != START_OUTSIDE || ray.shape == NONE || ray.medium != NONE {
        return best;
    }
    let list = primitives.coincident.of(ray.shape, ray.prim).iter();
    let mut touched = list.filter(|c| c.touches != 0).filter_map(|c| {
        let at = primitives.face_point(c, ray.o);
        at.within.then_some(Hit {
            t: F::zero(),
            shape: c.shape,
            prim: c.prim,
            uv: at.uv,
        })
    });
    touched.next().unwrap_or(best)
}
