//! Splits a node of the tree of lights.

use glam::DVec3;

use super::cone::Cone;
use super::emitter::Emitter;
use crate::shape::Bounds;

/// Slices of a node along an axis; it may be split between any two (pbrt 4, section 12.6.3).
const SLICES: usize = 12;

/// Splits `emitters`, at least two, into two non-empty parts, each small enough for a tree of `depth` levels.
pub fn halves(mut emitters: Vec<Emitter>, depth: u32) -> (Vec<Emitter>, Vec<Emitter>) {
    let n = emitters.len();
    if let Some(cut) = best(&emitters) {
        let (first, second): (Vec<_>, Vec<_>) = emitters
            .into_iter()
            .partition(|e| cut.slice_of(e) <= cut.last);
        if fits(first.len().max(second.len()), depth) {
            return (first, second);
        }
        emitters = first.into_iter().chain(second).collect();
    }
    // All at one position, or so far apart that a fair cut would take too many levels.
    let second = emitters.split_off(n / 2);
    (emitters, second)
}

/// Whether this many leaves fit below `depth` levels.
fn fits(leaves: usize, depth: u32) -> bool {
    depth >= 63 || leaves as u64 <= 1 << depth
}

/// A cut between two slices.
struct Cut {
    axis: usize,
    low: f64,
    extent: f64,
    /// The last slice of the first part.
    last: usize,
}

impl Cut {
    fn slice_of(&self, e: &Emitter) -> usize {
        let at = (e.bounds.centre()[self.axis] - self.low) / self.extent * SLICES as f64;
        (at as usize).min(SLICES - 1)
    }
}

/// The cut of least cost; `None` if all centres coincide.
fn best(emitters: &[Emitter]) -> Option<Cut> {
    let centres = emitters.iter().map(|e| Bounds::point(e.bounds.centre()));
    let all = centres.reduce(Bounds::union)?;
    let extent = all.hi - all.lo;
    let mut least: Option<(f64, Cut)> = None;
    for axis in (0..3).filter(|&axis| extent[axis] > 0.0) {
        let cut = |last| Cut {
            axis,
            low: all.lo[axis],
            extent: extent[axis],
            last,
        };
        let mut slices: [Option<Part>; SLICES] = [None; SLICES];
        for e in emitters {
            let slice = &mut slices[cut(0).slice_of(e)];
            *slice = Part::join(*slice, Some(Part::of(e)));
        }
        for last in 0..SLICES - 1 {
            let of = |s: &[Option<Part>]| s.iter().copied().fold(None, Part::join);
            let (Some(a), Some(b)) = (of(&slices[..=last]), of(&slices[last + 1..])) else {
                continue;
            };
            // Slices across a short axis are thin, so both costs are scaled to the longest axis.
            let cost = (a.cost() + b.cost()) * extent.max_element() / extent[axis];
            if least.as_ref().is_none_or(|(c, _)| cost < *c) {
                least = Some((cost, cut(last)));
            }
        }
    }
    least.map(|(_, cut)| cut)
}

/// Some of the emitters.
#[derive(Clone, Copy)]
struct Part {
    bounds: Bounds,
    cone: Cone,
    power: f64,
}

impl Part {
    fn of(e: &Emitter) -> Self {
        Self {
            bounds: e.bounds,
            cone: e.cone,
            power: e.power,
        }
    }

    fn join(a: Option<Self>, b: Option<Self>) -> Option<Self> {
        match (a, b) {
            (Some(a), Some(b)) => Some(Self {
                bounds: a.bounds.union(b.bounds),
                cone: a.cone.union(b.cone),
                power: a.power + b.power,
            }),
            (a, b) => a.or(b),
        }
    }

    /// Power times the size of its ball times the size of its cone, which ranges from 1 for a single normal to 3.5 for
    /// all directions (Conty Estevez & Kulla 2018, section 4.4).
    fn cost(&self) -> f64 {
        let size: DVec3 = self.bounds.hi - self.bounds.lo;
        self.power * size.length_squared() * (3.5 - 2.5 * self.cone.cosine)
    }
}
