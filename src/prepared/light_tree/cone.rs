//! Cones around normals.

use glam::DVec3;

/// Directions within an angle of at most 90° around an axis or its opposite: emitters emit from both sides.
#[derive(Clone, Copy, Debug)]
pub struct Cone {
    /// Unit length.
    pub axis: DVec3,
    /// Cosine of the angle; 0 covers every direction.
    pub cosine: f64,
}

impl Cone {
    pub const ALL: Self = Self {
        axis: DVec3::Z,
        cosine: 0.0,
    };

    /// One direction and its opposite; every direction for a vector of length zero.
    pub fn of(n: DVec3) -> Self {
        n.try_normalize()
            .map_or(Self::ALL, |axis| Self { axis, cosine: 1.0 })
    }

    /// A cone that contains both.
    pub fn union(self, other: Self) -> Self {
        let turned = if self.axis.dot(other.axis) < 0.0 {
            -other.axis
        } else {
            other.axis
        };
        let axis = (self.axis + turned).normalize();
        let cosine = self.seen_from(axis).min(other.seen_from(axis));
        Self { axis, cosine }
    }

    /// cos(a + b), where b is the angle between `axis` and this cone's axis, and a its half angle; 0 beyond 90°.
    fn seen_from(self, axis: DVec3) -> f64 {
        let cos_b = self.axis.dot(axis).abs().min(1.0);
        let sines = (1.0 - cos_b * cos_b) * (1.0 - self.cosine * self.cosine);
        (cos_b * self.cosine - sines.max(0.0).sqrt()).max(0.0)
    }
}
