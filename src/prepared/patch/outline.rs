//! Normals and outlines of flat patches.

use std::ops::Deref;

use glam::DVec3;

use super::Patch;
use crate::shape::Bounds;

impl Patch {
    /// The outward normal of a flat patch.
    pub(super) fn normal(&self) -> Option<DVec3> {
        match *self {
            Self::Rectangle { axis, upper, .. } => {
                let n = DVec3::AXES[axis];
                Some(if upper { n } else { -n })
            }
            Self::Triangle { normal, .. } | Self::Disc { normal, .. } => Some(normal),
            Self::Ball { .. } | Self::Side { .. } => None,
        }
    }

    /// Points on the outline of a flat patch, counter-clockwise around its normal: its corners, or four points on the
    /// rim of a disc.
    pub(super) fn outline(&self) -> Outline {
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
pub struct Outline {
    points: [DVec3; 4],
    count: usize,
}

impl Deref for Outline {
    type Target = [DVec3];

    fn deref(&self) -> &[DVec3] {
        &self.points[..self.count]
    }
}
