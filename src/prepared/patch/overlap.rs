//! Tests whether two patches coincide.

use glam::DVec3;

use super::{Orientation, Patch};

impl Patch {
    /// Whether the two share a piece of surface, not only a line.
    pub fn coincides(&self, other: &Self) -> Option<Orientation> {
        let near = self.near().min(other.near());
        let coincide = match (self, other) {
            (Self::Rectangle { .. }, Self::Rectangle { .. }) => rectangles(self, other),
            (
                Self::Ball { centre, radius },
                Self::Ball {
                    centre: c,
                    radius: r,
                },
            ) => centre.distance(*c) + (radius - r).abs() <= near,
            (Self::Side { .. }, Self::Side { .. }) => sides(self, other, near),
            _ => {
                let (n, m) = (self.normal()?, other.normal()?);
                (in_plane(self, n, other, near) || in_plane(other, m, self, near))
                    && overlap(self, other, near)
            }
        };
        let same = match (self.normal(), other.normal()) {
            (Some(n), Some(m)) => n.dot(m) > 0.0,
            // The outside of a solid's curved side is on the same side as the other's.
            _ => true,
        };
        let orientation = match same {
            true => Orientation::Same,
            false => Orientation::Opposite,
        };
        coincide.then_some(orientation)
    }
}

/// Faces of boxes, whose planes are compared after rounding to single precision.
fn rectangles(a: &Patch, b: &Patch) -> bool {
    let (
        Patch::Rectangle {
            axis, bounds: p, ..
        },
        Patch::Rectangle {
            axis: other,
            bounds: q,
            ..
        },
    ) = (a, b)
    else {
        return false;
    };
    let common = p.common(*q);
    axis == other
        && p.lo[*axis] as f32 == q.lo[*axis] as f32
        && (0..3).all(|k| k == *axis || common[k] > 0.0)
}

/// Sides of cylinders with a common axis: both ends of one lie on the other's axis.
fn sides(a: &Patch, b: &Patch, near: f64) -> bool {
    let (
        &Patch::Side {
            base,
            axis,
            height,
            radius,
        },
        &Patch::Side {
            base: q,
            axis: w,
            height: h,
            radius: r,
        },
    ) = (a, b)
    else {
        return false;
    };
    let above = |p: DVec3| (p - base).dot(axis);
    let beside = |p: DVec3| (p - base - axis * above(p)).length() <= near;
    let (from, to) = (above(q), above(q + w * h));
    let common = height.min(from.max(to)) - from.min(to).max(0.0);
    (radius - r).abs() <= near && beside(q) && beside(q + w * h) && common > near
}

/// Whether all of `b` lies in the plane of `a`, whose normal is n.
fn in_plane(a: &Patch, n: DVec3, b: &Patch, near: f64) -> bool {
    let lie = |p: DVec3, points: &[DVec3]| points.iter().all(|q| n.dot(*q - p).abs() <= near);
    match (a, b) {
        // The most frequent case is neighbours in a mesh, for which no outline is built.
        (Patch::Triangle { v: [p, ..], .. }, Patch::Triangle { v, .. }) => lie(*p, v),
        _ => a.outline().first().is_some_and(|p| lie(*p, &b.outline())),
    }
}

/// Whether two flat patches in one plane share more than an edge: no edge of either has the whole other patch on its
/// outer side.
fn overlap(a: &Patch, b: &Patch, near: f64) -> bool {
    if let (
        Patch::Disc { centre, radius, .. },
        Patch::Disc {
            centre: c,
            radius: r,
            ..
        },
    ) = (a, b)
    {
        return centre.distance(*c) < radius + r - near;
    }
    !parts(a, b, near) && !parts(b, a, near)
}

/// Whether an edge of `a` separates it from `b`.
fn parts(a: &Patch, b: &Patch, near: f64) -> bool {
    let (Some(n), false) = (a.normal(), matches!(a, Patch::Disc { .. })) else {
        return false;
    };
    let (corners, other) = (a.outline(), b.outline());
    (0..corners.len()).any(|i| {
        let (p, q) = (corners[i], corners[(i + 1) % corners.len()]);
        let inward = n.cross(q - p).normalize_or_zero();
        let furthest = match b {
            Patch::Disc { centre, radius, .. } => inward.dot(*centre - p) + radius,
            _ => {
                let inside = other.iter().map(|v| inward.dot(*v - p));
                inside.fold(f64::NEG_INFINITY, f64::max)
            }
        };
        furthest <= near
    })
}
