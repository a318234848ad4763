//! Axis-aligned boxes in `f64`.

use glam::DVec3;

/// The box { x : lo ≤ x ≤ hi }; empty where `lo` > `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub lo: DVec3,
    pub hi: DVec3,
}

impl Bounds {
    /// The neutral element of [`Bounds::union`].
    pub const EMPTY: Self = Self {
        lo: DVec3::INFINITY,
        hi: DVec3::NEG_INFINITY,
    };

    /// The box that contains only `p`.
    pub fn point(p: DVec3) -> Self {
        Self { lo: p, hi: p }
    }

    /// The smallest box that contains all points.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points
            .into_iter()
            .fold(Self::EMPTY, |all, p| all.union(Self::point(p)))
    }

    /// The smallest box that contains both.
    pub fn union(self, other: Self) -> Self {
        Self {
            lo: self.lo.min(other.lo),
            hi: self.hi.max(other.hi),
        }
    }

    /// The size of the intersection; negative along an axis with a gap between the boxes.
    pub fn common(self, other: Self) -> DVec3 {
        self.hi.min(other.hi) - self.lo.max(other.lo)
    }

    /// The middle, computed without overflow.
    pub fn centre(self) -> DVec3 {
        self.lo * 0.5 + self.hi * 0.5
    }

    /// Radius of the sphere through the corners.
    pub fn radius(self) -> f64 {
        ((self.hi - self.lo) * 0.5).length()
    }

    /// Half the surface; 0 if empty.
    pub fn half_area(self) -> f64 {
        let d = (self.hi - self.lo).max(DVec3::ZERO);
        d.x * d.y + d.y * d.z + d.z * d.x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2 × 3 × 4 and a cube of 2 that overlaps it by 1 along x, is 1 away along y, and is flush along z.
    #[test]
    fn boxes_by_hand() {
        let a = Bounds::around([DVec3::ZERO, DVec3::new(2.0, 3.0, 4.0)]);
        let b = Bounds::around([DVec3::new(1.0, 4.0, 4.0), DVec3::new(3.0, 6.0, 6.0)]);
        assert_eq!(a.common(b), DVec3::new(1.0, -1.0, 0.0));
        assert_eq!(a.union(b).hi, DVec3::new(3.0, 6.0, 6.0));
        assert_eq!(a.centre(), DVec3::new(1.0, 1.5, 2.0));
        assert_eq!(a.half_area(), 26.0);
        assert_eq!(b.radius(), 3f64.sqrt());
        let far = Bounds::point(DVec3::splat(f64::MAX));
        assert_eq!(far.centre(), far.lo);
    }

    #[test]
    fn the_empty_box_is_neutral_and_has_no_area() {
        let a = Bounds::point(DVec3::new(1.0, 2.0, 3.0));
        assert_eq!(Bounds::EMPTY.union(a), a);
        assert_eq!(Bounds::EMPTY.half_area(), 0.0);
        assert_eq!(Bounds::around([]), Bounds::EMPTY);
    }
}
