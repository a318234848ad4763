//! Which transmissive shape a point stands in, and which of them overlap.

use std::f64::consts::PI;

use glam::DVec3;

use super::geometry::Placed;
use super::{Bounds, Material, NONE, Shape, ShapeKind};

/// The material whose inside `p` stands in, or [`NONE`].
pub fn medium_at(p: DVec3, placed: &Placed, materials: &[Material]) -> u32 {
    placed
        .transmissive(materials)
        .find(|s| contains(placed, s, p))
        .map_or(NONE, |s| s.material)
}

fn contains(placed: &Placed, shape: &Shape, p: DVec3) -> bool {
    let first = shape.first as usize;
    match shape.kind {
        ShapeKind::Sphere => {
            let s = &placed.spheres[first];
            p.distance(s.centre) < s.radius
        }
        ShapeKind::Box => {
            let b = &placed.boxes[first];
            p.cmpgt(b.lo).all() && p.cmplt(b.hi).all()
        }
        ShapeKind::Cylinder => {
            let c = &placed.cylinders[first];
            let d = p - c.base;
            let z = d.dot(c.w);
            z > 0.0 && z < c.height && (d - c.w * z).length() < c.radius
        }
        ShapeKind::Mesh => {
            let triangles = &placed.triangles[first..first + shape.count as usize];
            let sum: f64 = triangles
                .iter()
                .map(|t| solid_angle(t.v.map(|v| v - p)))
                .sum();
            sum.abs() > 2.0 * PI
        }
    }
}

/// Signed solid angle of a triangle seen from the origin; over a closed mesh they add up to 4π inside, 0 outside.
///
/// tan(Ω/2) = a·(b×c) / (abc + (a·b)c + (a·c)b + (b·c)a): Van Oosterom & Strackee, The Solid Angle of a
/// Plane Triangle, 1983, eq. 8.
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let denominator = la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la;
    2.0 * a.dot(b.cross(c)).atan2(denominator)
}

/// Says once that transmissive shapes which overlap are outside the model (model.md, "Media").
pub fn warn_of_overlaps(placed: &Placed, materials: &[Material], warnings: &mut Vec<String>) {
    let rule =
        |(a, p): Bounded, (b, q): Bounded| p.common(q).min_element() > 0.0 && overlap(placed, a, b);
    if let Some([a, b]) = first_pair(placed, materials, rule) {
        warnings.push(format!(
            "the transmissive shapes of lines {a} and {b} overlap: every object stands in air in this model, so the \
             picture is wrong where they do"
        ));
    }
}

/// A shape and its bounds.
pub type Bounded<'a> = (&'a Shape, Bounds);

/// The lines, in order, of the first two transmissive shapes that obey `rule`.
pub fn first_pair(
    placed: &Placed,
    materials: &[Material],
    rule: impl Fn(Bounded, Bounded) -> bool,
) -> Option<[usize; 2]> {
    let all: Vec<Bounded> = placed
        .transmissive(materials)
        .map(|s| (s, placed.bounds(s)))
        .collect();
    all.iter().enumerate().find_map(|(i, &a)| {
        let &(b, _) = all[i + 1..].iter().find(|&&b| rule(a, b))?;
        Some([a.0.line.min(b.line), a.0.line.max(b.line)])
    })
}

/// Whether two shapes whose bounds overlap do so themselves: exact for spheres and boxes, assumed otherwise.
fn overlap(placed: &Placed, a: &Shape, b: &Shape) -> bool {
    match (a.kind, b.kind) {
        (ShapeKind::Sphere, ShapeKind::Sphere) => {
            let (a, b) = (
                &placed.spheres[a.first as usize],
                &placed.spheres[b.first as usize],
            );
            a.centre.distance(b.centre) < a.radius + b.radius
        }
        (ShapeKind::Sphere, ShapeKind::Box) => {
            let (s, b) = (
                &placed.spheres[a.first as usize],
                &placed.boxes[b.first as usize],
            );
            s.centre.distance(s.centre.clamp(b.lo, b.hi)) < s.radius
        }
        (ShapeKind::Box, ShapeKind::Sphere) => overlap(placed, b, a),
        _ => true,
    }
}
