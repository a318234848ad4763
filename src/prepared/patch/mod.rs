//! Faces of shapes as pieces of planes, spheres and cylinders, and a test of whether two of them coincide.

mod outline;
mod overlap;

use glam::DVec3;

use crate::shape::{Bounds, Cuboid, Cylinder, Sphere, Triangle};

/// How far rounding may move a coordinate of 1: 16 half-ulps of single precision, as far as it may lift a ray's origin
/// (`triangle_self_distance`). Surfaces closer than this coincide.
const NEAR: f64 = 16.0 / (1u64 << 24) as f64;

/// The geometry of one face.
#[derive(Clone, Debug, PartialEq)]
pub enum Patch {
    /// A face of a box: exact, because rounding moves no plane across an axis.
    Rectangle {
        axis: usize,
        upper: bool,
        bounds: Bounds,
    },
    /// Counter-clockwise around the outward unit normal.
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

    /// The faces of a box, numbered like a hit's primitive: 2 axis + (1 for hi, 0 for lo).
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

    /// Side, base and top of a cylinder, numbered like a hit's primitive.
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

    /// The bounding box.
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

    /// Whether its bounds are finite.
    pub fn is_finite(&self) -> bool {
        let Bounds { lo, hi } = self.bounds();
        lo.is_finite() && hi.is_finite()
    }

    /// The distance below which two points on or near it coincide.
    pub fn near(&self) -> f64 {
        let Bounds { lo, hi } = self.bounds();
        NEAR * lo.abs().max(hi.abs()).max_element()
    }
}

/// A disc of normal n extends r √(1 − n_k²) along axis k.
fn disc_bounds(centre: DVec3, normal: DVec3, radius: f64) -> Bounds {
    let reach = (DVec3::ONE - normal * normal)
        .max(DVec3::ZERO)
        .map(f64::sqrt)
        * radius;
    Bounds::around([centre - reach, centre + reach])
}
