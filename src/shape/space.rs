//! Rendering space: the scene moved to the origin and scaled to about 1.

use glam::DVec3;

use super::Bounds;

/// Where the origin of rendering space lies in the scene, and how long its unit is there.
///
/// Single precision holds lengths from 1e-38 to 3e38, but not their squares. In rendering space no coordinate is above 2,
/// whatever the scene's scale and place. The unit is a power of two: it rounds nothing, and changes no bit of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    pub origin: DVec3,
    pub unit: f64,
}

impl Space {
    /// About the middle of `shapes`, with `eye`, where rays begin, in it.
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

    /// A point of the scene in rendering space.
    pub fn point(&self, p: DVec3) -> DVec3 {
        (p - self.origin) / self.unit
    }

    /// A length of the scene in rendering space.
    pub fn length(&self, length: f64) -> f64 {
        length / self.unit
    }

    /// Where a point of rendering space lies in the scene.
    pub fn scene_point(&self, p: DVec3) -> DVec3 {
        self.origin + p * self.unit
    }
}

/// The largest power of two that is not above `x`, a normal positive number.
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
