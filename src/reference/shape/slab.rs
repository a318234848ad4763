//! The part of a ray between two parallel planes; twin of `shaders/shape/slab.glsl`.

use super::ray::{FAR, START_INSIDE};
use crate::reference::math::{Real, max2, min2};

/// The stretch of a ray between two parallel planes; empty where near > far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab<F> {
    pub near: F,
    pub far: F,
}

/// Below this a component of a unit vector moves no ray by a noticeable part of its length: the ray counts
/// as parallel, and no quotient overflows.
pub const PARALLEL: f64 = 1e-30;

/// The stretch with lo ≤ o + t d ≤ hi along one axis. A parallel ray is between the planes or it is not;
/// sliding along one of them it misses, unless it starts there to the inside.
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
