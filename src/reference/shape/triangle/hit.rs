//! The watertight ray/triangle test; twin of `shaders/shape/triangle/hit.glsl`.

use crate::reference::math::{Real, Vec3, difference_of_products, vec3};

/// The part of the test that depends only on a ray's direction: the axis along which it is longest becomes z, and the
/// shear x − sx z, y − sy z maps the ray onto it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayShear<F> {
    pub axis: u32,
    pub sx: F,
    pub sy: F,
    /// 1/d_z
    pub sz: F,
}

/// Distance to a triangle, or −1, and where: weights u, v of the second and third corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit<F> {
    pub t: F,
    pub u: F,
    pub v: F,
    /// Seen from behind: d·n > 0.
    pub back: bool,
}

/// The components in cyclic order, with `axis` last: orientation is preserved.
pub fn axis_last<F: Real>(v: Vec3<F>, axis: u32) -> Vec3<F> {
    if axis == 0 {
        vec3(v.y, v.z, v.x)
    } else if axis == 1 {
        vec3(v.z, v.x, v.y)
    } else {
        v
    }
}

/// The shear of a ray with direction `d`.
pub fn ray_shear<F: Real>(d: Vec3<F>) -> RayShear<F> {
    let (x, y, z) = (d.x.abs(), d.y.abs(), d.z.abs());
    let axis = if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    };
    let p = axis_last(d, axis);
    RayShear {
        axis,
        sx: p.x / p.z,
        sy: p.y / p.z,
        sz: F::one() / p.z,
    }
}

/// The hit with a triangle from both sides, or t = −1.
///
/// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013. A corner is sheared in the same way in
/// every triangle it belongs to, and swapping two corners changes only the sign of an edge function, exactly. An edge
/// function has the sign of the exact one of the sheared corners, and 0 counts as inside. So no ray passes between
/// triangles that share an edge or a corner. A triangle whose sheared corners lie on a line has the sum 0 and is never
/// hit.
///
/// The edge functions must be accurate relative to themselves, not only to the products from which they are computed:
/// otherwise a needle, or a triangle that is far smaller than its distance to the ray, is hit by rays that miss it by
/// more than its size, and t is as wrong as its weights are.
pub fn triangle_hit<F: Real>(
    o: Vec3<F>,
    shear: RayShear<F>,
    v0: Vec3<F>,
    v1: Vec3<F>,
    v2: Vec3<F>,
) -> TriangleHit<F> {
    let zero = F::zero();
    let a = axis_last(v0 - o, shear.axis);
    let b = axis_last(v1 - o, shear.axis);
    let c = axis_last(v2 - o, shear.axis);
    let ax = a.x - shear.sx * a.z;
    let ay = a.y - shear.sy * a.z;
    let bx = b.x - shear.sx * b.z;
    let by = b.y - shear.sy * b.z;
    let cx = c.x - shear.sx * c.z;
    let cy = c.y - shear.sy * c.z;
    // Twice the areas spanned by the ray and the edges opposite v0, v1, v2.
    let w0 = difference_of_products(bx, cy, by, cx);
    let w1 = difference_of_products(cx, ay, cy, ax);
    let w2 = difference_of_products(ax, by, ay, bx);
    let positive = w0 >= zero && w1 >= zero && w2 >= zero;
    let negative = w0 <= zero && w1 <= zero && w2 <= zero;
    let det = w0 + w1 + w2;
    let inverse = F::one() / if det == zero { F::one() } else { det };
    let t = (w0 * a.z + w1 * b.z + w2 * c.z) * shear.sz * inverse;
    TriangleHit {
        t: if (positive || negative) && det != zero && t > zero {
            t
        } else {
            -F::one()
        },
        u: w1 * inverse,
        v: w2 * inverse,
        // det = (n·d)/d_z
        back: (det > zero) == (shear.sz > zero),
    }
}
