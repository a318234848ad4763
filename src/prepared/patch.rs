//! Faces of shapes as pieces of planes, spheres and cylinders, and whether two of them coincide.

use std::ops::Deref;

use glam::DVec3;

use crate::shape::{Bounds, Cuboid, Cylinder, Sphere, Triangle};

/// How far rounding may move a coordinate of 1: 16 half-ulps of single precision, as far as it may lift a ray's origin
/// (`triangle_self_distance`). What is nearer than that is in one place.
const NEAR: f64 = 16.0 / (1u64 << 24) as f64;

/// The place of one face.
#[derive(Clone, Debug, PartialEq)]
pub enum Patch {
    /// A face of a box: exact, for no rounding moves a plane across an axis.
    Rectangle {
        axis: usize,
        upper: bool,
        bounds: Bounds,
    },
    /// Counter-clockwise about the outward unit normal.
    Triangle { v: [DVec3; 3], normal: DVec3 },
    /// `normal`: outward, of unit length.
    Disc {
        centre: DVec3,
        normal: DVec3,
        radius: f64,
    },
    /// A whole sphere.
    Ball { centre: DVec3, radius: f64 },
    /// The side of a cylinder from the base centre along its unit axis.
    Side {
        base: DVec3,
        axis: DVec3,
        height: f64,
        radius: f64,
    },
}

/// Two patches that coincide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// Their outward normals agree.
    Same,
    /// The outside of one is the inside of the other.
    Opposite,
}

impl Patch {
    pub fn sphere(s: &Sphere) -> Self {
        Self::Ball {
            centre: s.centre,
            radius: s.radius,
        }
    }

    /// The faces of a box, as a hit's primitive numbers them: 2 axis + (1 for hi, 0 for lo).
    pub fn cuboid(b: &Cuboid) -> [Self; 6] {
        std::array::from_fn(|face| {
            let (axis, upper) = (face / 2, face % 2 == 1);
            let mut bounds = Bounds::around([b.lo, b.hi]);
            let plane = if upper { b.hi[axis] } else { b.lo[axis] };
            (bounds.lo[axis], bounds.hi[axis]) = (plane, plane);
            Self::Rectangle {
                axis,
                upper,
                bounds,
            }
        })
    }

    /// Side, base and top of a cylinder, as a hit's primitive numbers them.
    pub fn cylinder(c: &Cylinder) -> [Self; 3] {
        let disc = |z: f64, normal: DVec3| Self::Disc {
            centre: c.base + c.w * z,
            normal,
            radius: c.radius,
        };
        let side = Self::Side {
            base: c.base,
            axis: c.w,
            height: c.height,
            radius: c.radius,
        };
        [side, disc(0.0, -c.w), disc(c.height, c.w)]
    }

    /// `None` for a triangle without area, which nothing hits.
    pub fn triangle(t: &Triangle) -> Option<Self> {
        let [a, b, c] = t.v;
        let size = (b - a).abs().max((c - a).abs()).max_element();
        let normal = ((b - a) / size).cross((c - a) / size).try_normalize()?;
        Some(Self::Triangle { v: t.v, normal })
    }

    /// The box about it.
    pub fn bounds(&self) -> Bounds {
        match *self {
            Self::Rectangle { bounds, .. } => bounds,
            Self::Triangle { v, .. } => Bounds::around(v),
            Self::Disc {
                centre,
                normal,
                radius,
            } => disc_bounds(centre, normal, radius),
            Self::Ball { centre, radius } => Bounds::around([centre - radius, centre + radius]),
            Self::Side {
                base,
                axis,
                height,
                radius,
            } => disc_bounds(base, axis, radius).union(disc_bounds(
                base + axis * height,
                axis,
                radius,
            )),
        }
    }

    /// Whether its bounds are.
    pub fn is_finite(&self) -> bool {
        let Bounds { lo, hi } = self.bounds();
        lo.is_finite() && hi.is_finite()
    }

    /// How near two places on it, or beside it, are one.
    pub fn near(&self) -> f64 {
        let Bounds { lo, hi } = self.bounds();
        NEAR * lo.abs().max(hi.abs()).max_element()
    }

    /// Whether the two have a piece of a surface in common, not only a line.
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
            // A solid's curved side turns its outside to the same side as the other's.
            _ => true,
        };
        let orientation = match same {
            true => Orientation::Same,
            false => Orientation::Opposite,
        };
        coincide.then_some(orientation)
    }

    /// The outward normal of what is flat.
    fn normal(&self) -> Option<DVec3> {
        match *self {
            Self::Rectangle { axis, upper, .. } => {
                let n = DVec3::AXES[axis];
                Some(if upper { n } else { -n })
            }
            Self::Triangle { normal, .. } | Self::Disc { normal, .. } => Some(normal),
            Self::Ball { .. } | Self::Side { .. } => None,
        }
    }

    /// Points of the outline of what is flat, counter-clockwise about its normal: the corners, or of a disc four points of
    /// the rim.
    fn outline(&self) -> Outline {
        match *self {
            Self::Rectangle {
                axis,
                upper,
                bounds: Bounds { lo, hi },
            } => {
                let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                let (j, k) = if upper { (j, k) } else { (k, j) };
                let with = |mut p: DVec3, axis: usize| {
                    p[axis] = hi[axis];
                    p
                };
                let mut points = [lo; 4];
                points[1] = with(lo, j);
                points[2] = with(points[1], k);
                points[3] = with(lo, k);
                Outline { points, count: 4 }
            }
            Self::Triangle { v: [a, b, c], .. } => Outline {
                points: [a, b, c, c],
                count: 3,
            },
            Self::Disc {
                centre,
                normal,
                radius,
            } => {
                let (u, v) = normal.any_orthonormal_pair();
                Outline {
                    points: [u, v, -u, -v].map(|d| centre + d * radius),
                    count: 4,
                }
            }
            Self::Ball { .. } | Self::Side { .. } => Outline {
                points: [DVec3::NAN; 4],
                count: 0,
            },
        }
    }
}

/// At most four points.
struct Outline {
    points: [DVec3; 4],
    count: usize,
}

impl Deref for Outline {
    type Target = [DVec3];

    fn deref(&self) -> &[DVec3] {
        &self.points[..self.count]
    }
}

/// A disc of normal n reaches r √(1 − n_k²) along axis k.
fn disc_bounds(centre: DVec3, normal: DVec3, radius: f64) -> Bounds {
    let reach = (DVec3::ONE - normal * normal)
        .max(DVec3::ZERO)
        .map(f64::sqrt)
        * radius;
    Bounds::around([centre - reach, centre + reach])
}

/// Faces of boxes, whose planes are what single precision makes of them.
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

/// Sides about one axis: both ends of one lie on the other's axis.
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
    let Some(&p) = a.outline().first() else {
        return false;
    };
    b.outline().iter().all(|q| n.dot(*q - p).abs() <= near)
}

/// Whether two flat patches of one plane have more in common than an edge: no edge of either has all of the other beyond it.
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

/// Whether an edge of `a` parts it from `b`.
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
