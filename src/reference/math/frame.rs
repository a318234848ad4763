//! Orthonormal frames about a normal; twin of `shaders/math/frame.glsl`.

use super::real::Real;
use super::vec::{Vec3, dot3, vec3};

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::math::{cross3, length3, normalize3};

    /// Largest departure from a right-handed orthonormal frame, measured in f64.
    fn departure(f: Frame<f32>) -> f64 {
        let widen = |v: Vec3<f32>| Vec3::<f64>::new(v.f64());
        let (t, b, n) = (widen(f.t), widen(f.b), widen(f.n));
        let right_handed = length3(cross3(t, b) - n);
        [
            length3(t) - 1.0,
            length3(b) - 1.0,
            dot3(t, b),
            dot3(t, n),
            dot3(b, n),
            right_handed,
        ]
        .into_iter()
        .fold(0.0, |worst, e| worst.max(e.abs()))
    }

    /// Three ulps of 1. A component of t or b is 1 or 0 and a product of three rounded factors at most 1
    /// (1½ ulp of it), and n itself is a unit vector to 1 ulp.
    const BOUND: f64 = 3.0 * f32::EPSILON as f64;

    /// The direction of (x, y, z), normalised in f64: in f32 the squares of the small ones would underflow.
    fn unit(x: f32, y: f32, z: f32) -> Vec3<f32> {
        let v = normalize3(vec3(f64::from(x), f64::from(y), f64::from(z)));
        Vec3::new(v.f64())
    }

    fn edge_normals() -> Vec<Vec3<f32>> {
        let mut edges = vec![
            vec3(0.0, 0.0, 1.0),
            vec3(0.0, 0.0, -1.0),
            vec3(1.0, 0.0, -0.0),
            vec3(0.0, -1.0, 0.0),
        ];
        // z one unit inside ±1, and x, y from whole to denormal: the singular direction of older forms
        for z in [
            -1.0 + f32::EPSILON / 2.0,
            1.0 - f32::EPSILON / 2.0,
            -1.0,
            1.0,
            -0.0,
            1e-30,
        ] {
            for x in [0.5, 1e-3, 3.45e-4, 1e-20, 1e-40, 0.0] {
                edges.extend([unit(x, x, z), unit(-x, 1e-4, z), unit(x, -1.0, z)]);
            }
        }
        edges
    }

    #[test]
    fn frames_are_orthonormal_and_right_handed() {
        let mut normals = edge_normals();
        let mut state = 1u32;
        let mut uniform = || {
            state = state.wrapping_mul(747796405).wrapping_add(2891336453);
            (state >> 8) as f32 / 8388608.0 - 1.0
        };
        normals.extend((0..200_000).map(|_| unit(uniform(), uniform(), uniform())));
        for n in normals {
            let e = departure(frame_about(n));
            assert!(e <= BOUND, "{n:?}: {e:e}");
        }
    }

    #[test]
    fn axis_aligned_frames_are_exact_and_a_tilted_one_is_noticed() {
        for n in [
            vec3(0.0, 0.0, 1.0),
            vec3(0.0, 0.0, -1.0),
            vec3(0.0, 1.0, 0.0),
            vec3(-1.0, 0.0, -0.0),
        ] {
            assert_eq!(departure(frame_about(n)), 0.0);
        }
        let mut tilted = frame_about(vec3(0.0f32, 0.6, 0.8));
        tilted.t.y += 1e-6;
        assert!(departure(tilted) > BOUND);
    }

    #[test]
    fn to_world_undoes_to_local() {
        let f = frame_about(normalize3(vec3(0.3f64, -0.4, -0.7)));
        let v = vec3(0.25, -1.5, 3.0);
        assert!(length3(to_world(f, to_local(f, v)) - v) < 1e-15);
        assert!(length3(to_local(f, f.n) - vec3(0.0, 0.0, 1.0)) < 1e-15);
    }
}
