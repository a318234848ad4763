//! Points on the faces of shapes; twin of `shaders/shape/face/`.

use super::r#box::Cuboid;
use super::cylinder::{CYLINDER_SIDE, Cylinder, cylinder_frame};
use super::triangle::area::abs3;
use super::triangle::hit::axis_last;
use crate::reference::math::frame::to_local;
use crate::reference::math::{Real, Vec3, cross3, difference_of_products};

/// A point of a face's plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacePoint<F> {
    /// On the face, including its edge.
    pub within: bool,
    /// Weights of a triangle's second and third corner.
    pub uv: [F; 2],
}

impl<F: Real> FacePoint<F> {
    /// A point on a face that has no weights, or off it.
    fn solid(within: bool) -> Self {
        Self {
            within,
            uv: [F::zero(); 2],
        }
    }
}

/// Every point of the sphere.
pub fn sphere_face_point<F: Real>() -> FacePoint<F> {
    FacePoint::solid(true)
}

/// `p`, in the plane of face 2 axis + (1 for hi, 0 for lo).
pub fn box_face_point<F: Real>(cuboid: &Cuboid<F>, face: u32, p: Vec3<F>) -> FacePoint<F> {
    let (lo, hi, axis) = (cuboid.lo, cuboid.hi, face / 2);
    let x = axis == 0 || (lo.x <= p.x && p.x <= hi.x);
    let y = axis == 1 || (lo.y <= p.y && p.y <= hi.y);
    let z = axis == 2 || (lo.z <= p.z && p.z <= hi.z);
    FacePoint::solid(x && y && z)
}

/// `p`, on the side, or in the plane of a cap.
pub fn cylinder_face_point<F: Real>(cylinder: &Cylinder<F>, part: u32, p: Vec3<F>) -> FacePoint<F> {
    let l = to_local(cylinder_frame(cylinder), p - cylinder.base);
    FacePoint::solid(match part {
        CYLINDER_SIDE => F::zero() <= l.z && l.z <= cylinder.height,
        _ => (l.x * l.x + l.y * l.y).sqrt() <= cylinder.radius,
    })
}

/// `p`, in the triangle's plane: seen along the axis that is nearest to the normal, by the signs of the edge functions
/// ([`triangle_hit`](super::triangle_hit)), so that no point falls between two triangles that share an edge.
pub fn triangle_face_point<F: Real>(
    v0: Vec3<F>,
    v1: Vec3<F>,
    v2: Vec3<F>,
    p: Vec3<F>,
) -> FacePoint<F> {
    let n = abs3(cross3(v1 - v0, v2 - v0));
    let axis = match n {
        n if n.x >= n.y && n.x >= n.z => 0,
        n if n.y >= n.z => 1,
        _ => 2,
    };
    let [a, b, c] = [v0, v1, v2].map(|v| axis_last(v - p, axis));
    let w0 = difference_of_products(b.x, c.y, b.y, c.x);
    let w1 = difference_of_products(c.x, a.y, c.y, a.x);
    let w2 = difference_of_products(a.x, b.y, a.y, b.x);
    let zero = F::zero();
    let positive = w0 >= zero && w1 >= zero && w2 >= zero;
    let negative = w0 <= zero && w1 <= zero && w2 <= zero;
    let det = w0 + w1 + w2;
    let inverse = F::one() / if det == zero { F::one() } else { det };
    FacePoint {
        within: (positive || negative) && det != zero,
        uv: [w1 * inverse, w2 * inverse],
    }
}
