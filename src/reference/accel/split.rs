//! Divides a set of boxes in two by the binned surface area heuristic.
//!
//! Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, IRT 2007.

use rayon::prelude::*;

use crate::shape::Extent;

const BINS: usize = 16;

/// A primitive for the builder.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    pub extent: Extent,
    pub primitive: u32,
}

/// Larger sets are binned on all cores.
const SERIAL: usize = 1 << 14;

/// Reorders `items`, at least two, and returns how many come first, never none and never all, and the boxes around both
/// parts; `None` if all centres coincide.
pub fn split(items: &mut [Item]) -> Option<(usize, [Extent; 2])> {
    let centre = |item: &Item| Extent::point(item.extent.twice_centre());
    let around_centres = |items: &[Item]| items.iter().map(centre).collect();
    let bins = Bins::of(over_parts(items, around_centres, Extent::union));
    let filled = over_parts(items, |part| bins.fill(part), merge);
    let Plane { axis, bin, extents } = cheapest_plane(&filled)?;
    let mut first = 0;
    for i in 0..items.len() {
        if bins.bin(items[i].extent.twice_centre(), axis) < bin {
            items.swap(first, i);
            first += 1;
        }
    }
    Some((first, extents))
}

/// `of_part` over all items: in parts, merged, where they are many. Over no items it must be neutral.
fn over_parts<T: Send>(
    items: &[Item],
    of_part: impl Fn(&[Item]) -> T + Sync,
    merge: impl Fn(T, T) -> T + Sync + Send,
) -> T {
    if items.len() <= SERIAL {
        return of_part(items);
    }
    let parts = items.par_chunks(SERIAL).map(&of_part);
    parts.reduce(|| of_part(&[]), merge)
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

    fn fill(&self, items: &[Item]) -> Filled {
        let mut filled = [[(Extent::EMPTY, 0); BINS]; 3];
        for item in items {
            let centre = item.extent.twice_centre();
            for (axis, bins) in filled.iter_mut().enumerate() {
                let (extent, count) = &mut bins[self.bin(centre, axis)];
                *extent = extent.union(item.extent);
                *count += 1;
            }
        }
        filled
    }
}

/// The box around the items of each axis and bin, and their number.
type Filled = [[(Extent, u32); BINS]; 3];

fn merge(mut a: Filled, b: Filled) -> Filled {
    for (a, b) in a.as_flattened_mut().iter_mut().zip(b.as_flattened()) {
        *a = (a.0.union(b.0), a.1 + b.1);
    }
    a
}

/// A plane that divides a set.
struct Plane {
    axis: usize,
    /// The first of the second part.
    bin: usize,
    /// Around each part.
    extents: [Extent; 2],
}

/// The plane of the least Σ area·count; `None` if on each axis one bin has all items.
fn cheapest_plane(filled: &Filled) -> Option<Plane> {
    let mut best = None;
    let mut least = f64::MAX;
    for (axis, bins) in filled.iter().enumerate() {
        let lower = sums(bins.iter());
        let upper = sums(bins.iter().rev());
        for bin in 1..BINS {
            let parts = [lower[bin - 1], upper[BINS - 1 - bin]];
            let cost: f64 = parts
                .map(|(extent, n)| extent.area() * f64::from(n))
                .iter()
                .sum();
            if parts.iter().all(|part| part.1 > 0) && cost < least {
                least = cost;
                let extents = parts.map(|part| part.0);
                best = Some(Plane { axis, bin, extents });
            }
        }
    }
    best
}

/// Box and number of items of the first bins, up to each.
fn sums<'a>(bins: impl Iterator<Item = &'a (Extent, u32)>) -> [(Extent, u32); BINS] {
    let mut sums = [(Extent::EMPTY, 0); BINS];
    let mut all = (Extent::EMPTY, 0);
    for (sum, bin) in sums.iter_mut().zip(bins) {
        all = (all.0.union(bin.0), all.1 + bin.1);
        *sum = all;
    }
    sums
}
