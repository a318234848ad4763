//! Rendering space: the scene moved to the origin and scaled to about 1.

use glam::DVec3;

use super::Bounds;

/// The origin of rendering space in the scene, and the length of its unit there.
///
/// Single precision covers lengths from 1e-38 to 3e38, but not their squares. In rendering space no coordinate is above
/// 2, at any position and scale of the scene. The unit is a power of two: it rounds nothing, and changes no bit of a
/// picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    pub origin: DVec3,
    pub unit: f64,
}

impl Space {
    /// Centred on `shapes`; the space also contains `eye`, where rays begin.
    pub fn of(shapes: Bounds, eye: Bounds) -> Self {
        let origin = shapes.centre();
        let all = shapes.union(eye);
        let extent = (all.lo - origin)
            .abs()
            .max((all.hi - origin).abs())
            .max_element();
        let unit = if extent > 0.0 {
            power_of_two(extent)
        } else {
            1.0
        };
        Self { origin, unit }
    }

    /// Transforms a point from the scene to rendering space.
    pub fn point(&self, p: DVec3) -> DVec3 {
        (p - self.origin) / self.unit
    }

    /// Transforms a length from the scene to rendering space.
    pub fn length(&self, length: f64) -> f64 {
        length / self.unit
    }

    /// Transforms a point from rendering space to the scene.
    pub fn scene_point(&self, p: DVec3) -> DVec3 {
        self.origin + p * self.unit
    }
}

/// The largest power of two ≤ `x`, a normal positive number.
fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits(x.to_bits() & EXPONENT)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_below_2_and_come_back() {
        for extent in [1e-30, 0.7, 1.0, 3.0, 3e38] {
            let eye = DVec3::new(0.0, extent, 0.0);
            let shapes = Bounds {
                lo: DVec3::splat(-0.25 * extent),
                hi: DVec3::splat(0.25 * extent),
            };
            let space = Space::of(shapes, Bounds::point(eye));
            let y = space.point(eye).y;
            assert!((1.0..2.0).contains(&y), "{extent:e}: {y}");
            assert_eq!(space.scene_point(space.point(eye)), eye);
            assert_eq!(space.unit.to_bits() << 12, 0, "a power of two");
        }
        let nothing = Bounds::point(DVec3::ONE);
        assert_eq!(Space::of(nothing, Bounds::point(DVec3::ONE)).unit, 1.0);
    }
}
