//! Where to divide a set of boxes in two: binned surface area heuristic.
//!
//! Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, IRT 2007.

use crate::shape::Extent;

const BINS: usize = 16;

/// A primitive for the builder.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    pub extent: Extent,
    pub primitive: u32,
}

/// Reorders `items` (two at least) and returns how many come first; never none, never all.
pub fn split(items: &mut [Item]) -> usize {
    let centres = items.iter().fold(Extent::EMPTY, |all, item| {
        all.union(Extent::point(item.extent.twice_centre()))
    });
    let bins = Bins::of(centres);
    let Some((axis, plane)) = bins.cheapest_plane(items) else {
        return items.len() / 2;
    };
    let mut first = 0;
    for i in 0..items.len() {
        if bins.bin(items[i].extent.twice_centre(), axis) < plane {
            items.swap(first, i);
            first += 1;
        }
    }
    first
}

/// The bins between the least and the largest centre.
struct Bins {
    lo: [f32; 3],
    /// Bins per length; 0 where an axis has no extent, which puts all into bin 0.
    scale: [f32; 3],
}

impl Bins {
    fn of(centres: Extent) -> Self {
        let scale = |axis: usize| {
            let scale = BINS as f32 / (centres.hi[axis] - centres.lo[axis]);
            if scale.is_finite() { scale } else { 0.0 }
        };
        Self {
            lo: centres.lo,
            scale: [scale(0), scale(1), scale(2)],
        }
    }

    /// 0 … BINS − 1
    fn bin(&self, centre: [f32; 3], axis: usize) -> usize {
        let place = (centre[axis] - self.lo[axis]) * self.scale[axis];
        (place as usize).min(BINS - 1)
    }

    /// The axis and the first bin of the second part, at the least Σ area·count; `None` if all centres coincide.
    fn cheapest_plane(&self, items: &[Item]) -> Option<(usize, usize)> {
        let mut bins = [[(Extent::EMPTY, 0); BINS]; 3];
        for item in items {
            let centre = item.extent.twice_centre();
            for (axis, bins) in bins.iter_mut().enumerate() {
                let (extent, count) = &mut bins[self.bin(centre, axis)];
                *extent = extent.union(item.extent);
                *count += 1;
            }
        }
        let mut best = None;
        let mut least = f64::MAX;
        for (axis, bins) in bins.iter().enumerate() {
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
}

/// area·count and count of the first bins up to each.
fn costs<'a>(bins: impl Iterator<Item = &'a (Extent, u32)>) -> [(f64, u32); BINS] {
    let mut sums = [(0.0, 0); BINS];
    let mut all = (Extent::EMPTY, 0);
    for (sum, bin) in sums.iter_mut().zip(bins) {
        all = (all.0.union(bin.0), all.1 + bin.1);
        *sum = (all.0.area() * f64::from(all.1), all.1);
    }
    sums
}
