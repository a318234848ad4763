//! Orthonormal frames about a normal; twin of `shaders/math/frame.glsl`.

use super::real::Real;
use super::vec3::{Vec3, dot3, vec3};

/// A right-handed frame (t, b, n), each of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Frame<F> {
    pub t: Vec3<F>,
    pub b: Vec3<F>,
    pub n: Vec3<F>,
}

/// A frame about the unit vector `n`, without a branch and without a singular direction.
///
/// Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017, listing 3. Exact for axis-aligned `n`.
pub fn frame_about<F: Real>(n: Vec3<F>) -> Frame<F> {
    let one = F::one();
    let s = if n.z < F::zero() { -one } else { one };
    let a = -one / (s + n.z);
    let b = n.x * n.y * a;
    Frame {
        t: vec3(one + s * n.x * n.x * a, s * b, -s * n.x),
        b: vec3(b, s + n.y * n.y * a, -n.y),
        n,
    }
}

/// World → local: (v·t, v·b, v·n).
pub fn to_local<F: Real>(f: Frame<F>, v: Vec3<F>) -> Vec3<F> {
    vec3(dot3(v, f.t), dot3(v, f.b), dot3(v, f.n))
}

/// Local → world: t v.x + b v.y + n v.z.
pub fn to_world<F: Real>(f: Frame<F>, v: Vec3<F>) -> Vec3<F> {
    f.t * v.x + f.b * v.y + f.n * v.z
}
