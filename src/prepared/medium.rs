//! The transmissive shape that contains a point, and overlaps of such shapes.

use glam::DVec3;

use super::placed::Placed;
use super::{Material, NONE};
use crate::shape::{Body, Bounds};

/// The transmissive shapes of a scene: their materials, bodies and bounds.
pub struct Media<'a>(Vec<(u32, Bounded<'a>)>);

impl<'a> Media<'a> {
    pub fn new(placed: &'a Placed, materials: &'a [Material]) -> Self {
        let bounded = |shape| {
            let body = placed.body(shape);
            let bounds = body.bounds();
            (shape.material, (body, bounds))
        };
        Self(placed.transmissive(materials).map(bounded).collect())
    }

    /// The material of the shape that contains `p`, or [`NONE`].
    pub fn at(&self, p: DVec3) -> u32 {
        let contains = |(body, bounds): &Bounded| {
            p.cmpge(bounds.lo).all() && p.cmple(bounds.hi).all() && body.contains(p)
        };
        let found = self.0.iter().find(|(_, bounded)| contains(bounded));
        found.map_or(NONE, |(material, _)| *material)
    }
}

/// Warns once if transmissive shapes overlap, which the model excludes (model.md, "Media").
pub fn warn_of_overlaps(placed: &Placed, materials: &[Material], warnings: &mut Vec<String>) {
    let rule = |(a, p): &Bounded, (b, q): &Bounded| {
        p.common(*q).min_element() > 0.0 && overlap(&**a, &**b)
    };
    if let Some([a, b]) = first_pair(placed, materials, rule) {
        warnings.push(format!(
            "the transmissive shapes of lines {a} and {b} overlap: the model assumes air around every object, so the \
             picture is wrong where they overlap; move them apart"
        ));
    }
}

/// A shape and its bounds.
pub type Bounded<'a> = (Box<dyn Body + 'a>, Bounds);

/// The lines, in order, of the first two transmissive shapes that satisfy `rule`.
pub fn first_pair(
    placed: &Placed,
    materials: &[Material],
    rule: impl Fn(&Bounded, &Bounded) -> bool,
) -> Option<[usize; 2]> {
    let lines: Vec<usize> = placed.transmissive(materials).map(|s| s.line).collect();
    let all: Vec<Bounded> = placed
        .transmissive(materials)
        .map(|s| placed.body(s))
        .map(|body| {
            let bounds = body.bounds();
            (body, bounds)
        })
        .collect();
    all.iter().enumerate().find_map(|(i, a)| {
        let j = (i + 1..all.len()).find(|&j| rule(a, &all[j]))?;
        Some([lines[i].min(lines[j]), lines[i].max(lines[j])])
    })
}

/// Whether two shapes overlap, given that their bounds do: exact for spheres and boxes, assumed otherwise.
pub fn overlap(a: &dyn Body, b: &dyn Body) -> bool {
    match (a.ball(), b.ball()) {
        (Some((centre, radius)), _) => b.overlaps_ball(centre, radius),
        (_, Some((centre, radius))) => a.overlaps_ball(centre, radius),
        _ => true,
    }
}
