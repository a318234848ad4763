//! Where to divide a set of boxes in two: binned surface area heuristic.
//!
//! Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, IRT 2007.

use glam::DVec3;

use crate::shape::Bounds;

const BINS: usize = 16;

/// A primitive for the builder.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    pub bounds: Bounds,
    pub primitive: u32,
}

/// Reorders `items` (two at least) and returns how many come first; never none, never all.
pub fn split(items: &mut [Item]) -> usize {
    let centres = Bounds::around(items.iter().map(|item| item.bounds.centre()));
    let half = items.len() / 2;
    let Some((axis, plane)) = cheapest_plane(items, centres) else {
        return half;
    };
    let mut first = 0;
    for i in 0..items.len() {
        if bin(items[i].bounds.centre(), centres, axis) < plane {
            items.swap(first, i);
            first += 1;
        }
    }
    first
}

/// The axis and the first bin of the second part, at the least Σ area·count; `None` if all centres coincide.
fn cheapest_plane(items: &[Item], centres: Bounds) -> Option<(usize, usize)> {
    let mut best = None;
    let mut least = f64::MAX;
    for axis in 0..3 {
        let mut bins = [(Bounds::EMPTY, 0); BINS];
        for item in items {
            let (bounds, count) = &mut bins[bin(item.bounds.centre(), centres, axis)];
            *bounds = bounds.union(item.bounds);
            *count += 1;
        }
        let upper = costs(bins.iter().rev());
        let lower = costs(bins.iter());
        for plane in 1..BINS {
            let ((cost_lower, below), (cost_upper, above)) =
                (lower[plane - 1], upper[BINS - 1 - plane]);
            if below > 0 && above > 0 && cost_lower + cost_upper < least {
                least = cost_lower + cost_upper;
                best = Some((axis, plane));
            }
        }
    }
    best
}

/// area·count and count of the first bins up to each.
fn costs<'a>(bins: impl Iterator<Item = &'a (Bounds, u32)>) -> [(f64, u32); BINS] {
    let mut sums = [(0.0, 0); BINS];
    let mut all = (Bounds::EMPTY, 0);
    for (sum, bin) in sums.iter_mut().zip(bins) {
        all = (all.0.union(bin.0), all.1 + bin.1);
        *sum = (all.0.half_area() * f64::from(all.1), all.1);
    }
    sums
}

/// The bin of a centre among `centres`, 0 … BINS − 1; all in bin 0 where the axis has no extent.
fn bin(centre: DVec3, centres: Bounds, axis: usize) -> usize {
    let extent = centres.hi[axis] - centres.lo[axis];
    let share = (centre[axis] - centres.lo[axis]) / extent.max(f64::MIN_POSITIVE);
    ((share * BINS as f64) as usize).min(BINS - 1)
}
