//! Up to eight primitives side by side, and which of them a ray certainly misses.
//!
//! The triangle test (`shape/triangle/hit.rs`) misses where one edge function is positive and another negative. An edge
//! function is p − q for two products p and q, computed so that its sign is right. Rounding keeps order: if p < q, then
//! p rounded ≤ q rounded. So the plain difference of the rounded products has the right sign or is 0, and eight of them
//! are computed at once. Where it does not exceed [`FAINT`], and for every primitive that may be hit, the test itself
//! decides: no bit of a hit depends on this file.

use crate::reference::math::lanes::{Bits, Lanes, WIDTH};
use crate::reference::math::{Real, Vec3};
use crate::reference::primitives::Primitives;
use crate::reference::shape::RayShear;

/// In units of [`Real::LEAST_NORMAL`], 2²⁴: a larger difference is one of products whose errors do not underflow, so
/// the test computes its sign correctly.
const FAINT: f64 = 16_777_216.0;

/// Primitives of a leaf. One that is no triangle has NaN corners: it is never ruled out.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub struct Leaf<F> {
    /// By corner, axis and primitive.
    corners: [[[F; WIDTH]; 3]; 3],
    /// Numbers of the primitives; those from `count` on are ignored.
    numbers: [u32; WIDTH],
    count: u32,
}

impl<F: Real> Leaf<F> {
    /// The leaf of these primitives, 1 … [`WIDTH`] of them.
    pub fn new(primitives: &Primitives<F>, numbers: impl Iterator<Item = u32>) -> Self {
        let mut corners = [[[F::new(f64::NAN); WIDTH]; 3]; 3];
        let (mut all, mut count) = ([0; WIDTH], 0);
        for (i, number) in numbers.enumerate() {
            (all[i], count) = (number, i as u32 + 1);
            let Some(triangle) = primitives.triangle(number as usize) else {
                continue;
            };
            for (corner, v) in corners.iter_mut().zip(triangle.v) {
                (corner[0][i], corner[1][i], corner[2][i]) = (v.x, v.y, v.z);
            }
        }
        Self {
            corners,
            numbers: all,
            count,
        }
    }

    /// Its primitives.
    #[cfg(test)]
    pub fn numbers(&self) -> impl Iterator<Item = u32> {
        self.numbers.into_iter().take(self.count as usize)
    }

    /// The primitives that the ray from `o` may hit.
    #[inline(always)]
    pub fn candidates(&self, o: Vec3<F>, shear: RayShear<F>) -> impl Iterator<Item = usize> {
        let all = (1 << self.count) - 1;
        Bits(all & !self.missed(o, shear)).map(|i| self.numbers[i & (WIDTH - 1)] as usize)
    }

    /// Bit i: the ray certainly misses primitive i.
    #[inline(always)]
    fn missed(&self, o: Vec3<F>, shear: RayShear<F>) -> u32 {
        let z = shear.axis as usize % 3;
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let o = [o.x, o.y, o.z];
        let o = [o[x], o[y], o[z]].map(F::Lanes::splat);
        let [sx, sy] = [shear.sx, shear.sy].map(F::Lanes::splat);
        // The sheared corners of the test, bit for bit.
        let sheared = |corner: &[[F; WIDTH]; 3]| {
            let corner = [x, y, z].map(|axis| F::Lanes::new(corner[axis]));
            let away = corner[2] - o[2];
            [
                (corner[0] - o[0]) - sx * away,
                (corner[1] - o[1]) - sy * away,
            ]
        };
        let [a, b, c] = &self.corners;
        let (a, b, c) = (sheared(a), sheared(b), sheared(c));
        let edge = |a: [F::Lanes; 2], b: [F::Lanes; 2]| a[0] * b[1] - a[1] * b[0];
        let (w0, w1, w2) = (edge(b, c), edge(c, a), edge(a, b));
        let faint = F::LEAST_NORMAL * F::new(FAINT);
        let positive = w0.max(w1).max(w2).above(F::Lanes::splat(faint));
        let negative = F::Lanes::splat(-faint).above(w0.min(w1).min(w2));
        positive & negative
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::math::vec3;
    use crate::reference::shape::{Triangle, ray_shear, triangle_hit};
    use crate::shape;

    /// A number in −1 … 1, often one of few, so that rays meet edges and corners, and sometimes tiny.
    fn coordinate(state: &mut u32) -> f32 {
        *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let x = (*state >> 8) as f32 / 8_388_608.0 - 1.0;
        match *state >> 30 {
            0 => (x * 4.0).round() / 4.0,
            1 => x * 1e-20,
            _ => x,
        }
    }

    #[test]
    fn hits_of_the_test_are_never_missed_and_most_misses_are_spared() {
        let mut state = 3;
        let (mut hits, mut misses, mut spared) = (0, 0, 0);
        for round in 0..50_000 {
            let mut point = || {
                let mut x = || coordinate(&mut state);
                vec3(x(), x(), x())
            };
            let mut primitives = Primitives::<f32>::new(&shape::Primitives::default());
            let triangle = |_| Triangle {
                v: [point(), point(), point()],
                shape: 0,
            };
            primitives.triangles = (0..WIDTH).map(triangle).collect();
            let o = point();
            // Anywhere, through a corner of the first, or through its edge up to rounding.
            let [a, b, _] = primitives.triangles[0].v;
            let to = match round % 3 {
                0 => point(),
                1 => b,
                _ => a + (b - a) * 0.3,
            };
            let shear = ray_shear(to - o);
            let missed = Leaf::new(&primitives, 0..WIDTH as u32).missed(o, shear);
            for (i, triangle) in primitives.triangles.iter().enumerate() {
                let [a, b, c] = triangle.v;
                let hit = triangle_hit(o, shear, a, b, c).t > 0.0;
                let sure = missed & (1 << i) != 0;
                assert!(!(hit && sure), "{o:?} {to:?} {triangle:?}");
                hits += u32::from(hit);
                misses += u32::from(!hit);
                spared += u32::from(sure);
            }
        }
        assert!(hits > 10_000, "{hits}");
        // The others lie behind the ray, or nearly on an edge.
        assert!(
            f64::from(spared) > 0.8 * f64::from(misses),
            "{spared} of {misses}"
        );
    }

    #[test]
    fn nothing_is_certain_of_a_solid() {
        let mut primitives = Primitives::<f64>::new(&shape::Primitives::default());
        primitives.spheres = vec![crate::reference::shape::Sphere {
            centre: vec3(0.0, 0.0, 0.0),
            radius: 1.0,
            shape: 0,
        }];
        let leaf = Leaf::new(&primitives, 0..1);
        let shear = ray_shear(vec3(0.0, 0.0, 1.0));
        let all: Vec<usize> = leaf.candidates(vec3(9.0, 9.0, 9.0), shear).collect();
        assert_eq!(all, [0]);
    }
}
