//! The part of a ray between two parallel planes; twin of `shaders/shape/slab.glsl`.

use crate::layout::constants::ray::{FAR, PARALLEL, START_ELSEWHERE, START_INSIDE};
use crate::reference::math::{Real, max2, min2};

/// An interval of a ray; empty where near > far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab<F> {
    pub near: F,
    pub far: F,
}

/// The interval with lo ≤ o + t d ≤ hi along one axis. A parallel ray is either between the planes or not; sliding
/// along one of them it misses, unless it starts there to the inside.
#[inline(always)]
pub fn slab<F: Real>(o: F, d: F, lo: F, hi: F, start: u32) -> Slab<F> {
    let parallel = d.abs() < F::new(PARALLEL);
    let between = start == START_INSIDE || (lo < o && o < hi);
    let inverse = F::one() / if parallel { F::one() } else { d };
    let t_lo = (lo - o) * inverse;
    let t_hi = (hi - o) * inverse;
    let far = if between { F::new(FAR) } else { -F::new(FAR) };
    Slab {
        near: if parallel { -far } else { min2(t_lo, t_hi) },
        far: if parallel { far } else { max2(t_lo, t_hi) },
    }
}

/// Whether a ray meets a convex solid, which it crosses in the interval `s`, at its entry.
#[inline(always)]
pub fn enters<F: Real>(s: Slab<F>, start: u32) -> bool {
    s.near > F::zero() && start == START_ELSEWHERE
}

/// Where a ray first meets a convex solid that it crosses in the interval `s`, or −1. If it leaves to the outside:
/// never. To the inside: at the exit, t ≥ 0, always found. From elsewhere: the least t > 0.
#[inline(always)]
pub fn first_of<F: Real>(s: Slab<F>, start: u32) -> F {
    let found = s.near <= s.far && s.far > F::zero() && start == START_ELSEWHERE;
    let t = if enters(s, start) { s.near } else { s.far };
    let elsewhere = if found { t } else { -F::one() };
    if start == START_INSIDE {
        max2(s.far, F::zero())
    } else {
        elsewhere
    }
}
