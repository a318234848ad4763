//! Glass that stands on glass, face on face.
//!
//! A ray that leaves a solid passes over what begins at the very point that it starts from, or the glass that stands on a table
//! would be entered by what the table reflects (`shape`). So between two solids of glass without a gap one is left that was never
//! entered, or never left: wrong by (n₁/n₂)², where nothing tells so.

use super::Material;
use super::eye::ACCURACY;
use super::medium::{Bounded, first_pair};
use super::placed::Placed;
use crate::shape::Body;

/// Says once that two transmissive shapes have a part of a plane in common, as far as single precision tells; of planes
/// across the axes of the world.
pub fn warn_of_contacts(placed: &Placed, materials: &[Material], warnings: &mut Vec<String>) {
    if let Some([a, b]) = first_pair(placed, materials, touch) {
        warnings.push(format!(
            "the transmissive shapes of lines {a} and {b} touch along a face: light that goes from one into the other is \
             wrong by the squares of their indices of refraction; leave a gap between them, however thin"
        ));
    }
}

/// Whether two shapes are flat where their bounds touch.
fn touch((a, p): &Bounded, (b, q): &Bounded) -> bool {
    let size = [p.lo, p.hi, q.lo, q.hi].map(|v| v.abs().max_element());
    let near = ACCURACY * size.into_iter().fold(0.0, f64::max);
    let common = p.common(*q);
    (0..3).any(|k| {
        let beside = (0..3).all(|j| j == k || common[j] > near);
        let meet = |a: &dyn Body, top: f64, b: &dyn Body, bottom: f64| {
            (top - bottom).abs() <= near && a.is_flat(k, top, near) && b.is_flat(k, bottom, near)
        };
        beside && (meet(&**a, p.hi[k], &**b, q.lo[k]) || meet(&**b, q.hi[k], &**a, p.lo[k]))
    })
}
