//! Glass that stands on glass, face on face.
//!
//! A ray that leaves a solid passes over what begins at the very point that it starts from, or the glass that stands on a table
//! would be entered by what the table reflects (`shape`). So between two solids of glass without a gap one is left that was never
//! entered, or never left: wrong by (n₁/n₂)², where nothing tells so.

use super::eye::ACCURACY;
use super::geometry::Placed;
use super::medium::{Bounded, first_pair};
use super::{Material, Shape, ShapeKind};

/// Says once that two transmissive shapes have a part of a plane in common, as far as single precision tells; of planes
/// across the axes of the world.
pub fn warn_of_contacts(placed: &Placed, materials: &[Material], warnings: &mut Vec<String>) {
    if let Some([a, b]) = first_pair(placed, materials, |a, b| touch(placed, a, b)) {
        warnings.push(format!(
            "the transmissive shapes of lines {a} and {b} touch along a face: light that goes from one into the other is \
             wrong by the squares of their indices of refraction; leave a gap between them, however thin"
        ));
    }
}

/// Whether two shapes are flat where their bounds touch.
fn touch(placed: &Placed, (a, p): Bounded, (b, q): Bounded) -> bool {
    let size = [p.lo, p.hi, q.lo, q.hi].map(|v| v.abs().max_element());
    let near = ACCURACY * size.into_iter().fold(0.0, f64::max);
    let common = p.common(q);
    (0..3).any(|k| {
        let beside = (0..3).all(|j| j == k || common[j] > near);
        let meet = |a: &Shape, top: f64, b: &Shape, bottom: f64| {
            (top - bottom).abs() <= near
                && flat(placed, a, k, top, near)
                && flat(placed, b, k, bottom, near)
        };
        beside && (meet(a, p.hi[k], b, q.lo[k]) || meet(b, q.hi[k], a, p.lo[k]))
    })
}

/// Whether a face of the shape lies in the plane where coordinate `k` is `at`, an end of its bounds.
fn flat(placed: &Placed, shape: &Shape, k: usize, at: f64, near: f64) -> bool {
    let first = shape.first as usize;
    match shape.kind {
        ShapeKind::Sphere => false,
        ShapeKind::Box => true,
        // A cap's edge reaches r·√(1 − w_k²) out of the plane.
        ShapeKind::Cylinder => {
            let c = &placed.cylinders[first];
            let [i, j] = [(k + 1) % 3, (k + 2) % 3];
            c.w[i].hypot(c.w[j]) * c.radius <= near
        }
        ShapeKind::Mesh => placed.triangles[first..first + shape.count as usize]
            .iter()
            .any(|t| t.v.iter().all(|v| (v[k] - at).abs() <= near)),
    }
}
