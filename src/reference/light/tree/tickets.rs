//! A lottery: a choice that is subdivided repeatedly, with probabilities that are ratios of whole numbers; twin of
//! `shaders/light/tree/tickets.glsl`.

use crate::reference::math::Real;

/// `drawn` is one of `count` tickets, each as likely as the others. So the probability of a choice is exact, and the
/// rest of the random number after it is uniform again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tickets {
    pub drawn: u32,
    pub count: u32,
    /// Random bits not yet used, taken eight at a time, and how often.
    pub spare: u32,
    pub spares: u32,
}

/// The tickets of a block of random numbers: 31 bits of the first, and the bits of the others from which no point is drawn.
pub fn all_tickets(u: [u32; 4]) -> Tickets {
    Tickets {
        drawn: u[0] >> 1,
        count: 0x8000_0000,
        spare: (u[1] & 255) | ((u[2] & 255) << 8) | ((u[3] & 255) << 16),
        spares: 3,
    }
}

/// 256 tickets in place of each, once fewer than 2²³ are left: a share of them is then as fine as a float.
pub fn refilled(t: Tickets) -> Tickets {
    if t.count < 0x80_0000 && t.spares > 0 {
        Tickets {
            drawn: (t.drawn << 8) | (t.spare & 255),
            count: t.count << 8,
            spare: t.spare >> 8,
            spares: t.spares - 1,
        }
    } else {
        t
    }
}

/// How many of `count` tickets fall to the first of two, for weights `a` and `b` that are not both 0: in proportion,
/// but at least one to each whose weight is not 0, as long as there are two.
pub fn first_share<F: Real>(count: u32, a: F, b: F) -> u32 {
    let share = (a / (a + b) * F::from_u32(count)).to_u32();
    let share = share.max(u32::from(a > F::zero()));
    // among 2²⁴ tickets or more, a float may lose some: the first gets all if the second has no weight
    if b > F::zero() {
        share.min(count - 1)
    } else {
        count
    }
}
