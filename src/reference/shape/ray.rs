//! Rays, hits, surfaces, and the order among hits; twin of `shaders/shape/ray.glsl`.

pub use crate::layout::constants::ray::{FAR, START_ELSEWHERE, START_INSIDE, START_OUTSIDE};
use crate::prepared::NONE;
use crate::reference::math::{Real, Vec3};

/// The half-line o + t d, 0 < t < t_max, with the surface on which it starts and the medium in which it travels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<F> {
    pub o: Vec3<F>,
    /// [`FAR`] if nothing limits it.
    pub t_max: F,
    /// Unit length.
    pub d: Vec3<F>,
    /// The shape on which it starts, or [`NONE`].
    pub shape: u32,
    /// The primitive on which it starts, as in [`Hit::prim`], or [`NONE`].
    pub prim: u32,
    /// The side of `shape` to which it leaves: [`START_ELSEWHERE`], [`START_OUTSIDE`] or [`START_INSIDE`].
    pub start: u32,
    /// How far the origin's rounding error reaches along the ray, if it starts on a mesh; else 0. See
    /// [`triangle_self_distance`](super::triangle_self_distance).
    pub t_self: F,
    /// The material in which it travels, or [`NONE`].
    pub medium: u32,
}

impl<F: Real> Ray<F> {
    /// A ray without end that starts on no surface, in air.
    pub fn new(o: Vec3<F>, d: Vec3<F>) -> Self {
        Self {
            o,
            t_max: F::new(FAR),
            d,
            shape: NONE,
            prim: NONE,
            start: START_ELSEWHERE,
            t_self: F::zero(),
            medium: NONE,
        }
    }
}

/// The target of a shadow ray, which must not stop it: a solid, or one triangle of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    pub shape: u32,
    /// As in [`Hit::prim`]; no other face of a solid is met either.
    pub prim: u32,
}

impl Target {
    /// Nothing is skipped.
    pub fn none() -> Self {
        Self {
            shape: NONE,
            prim: NONE,
        }
    }
}

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<F> {
    /// Distance; the limit of the search if nothing is hit.
    pub t: F,
    /// [`NONE`]: nothing is hit.
    pub shape: u32,
    /// Triangle (index among all), face of a box, part of a cylinder, 0 for a sphere.
    pub prim: u32,
    /// Weights of a triangle's second and third corner.
    pub uv: [F; 2],
}

/// A point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<F> {
    /// On the surface, as exactly as `F` allows.
    pub p: Vec3<F>,
    /// Outward geometric normal, unit length.
    pub ng: Vec3<F>,
    /// Shading normal on the side of `ng`, unit length.
    pub ns: Vec3<F>,
}

/// Nothing is hit before `t_max`.
pub fn no_hit<F: Real>(t_max: F) -> Hit<F> {
    Hit {
        t: t_max,
        shape: NONE,
        prim: NONE,
        uv: [F::zero(); 2],
    }
}

/// Whether a hit comes before `best`: the least (t, shape, prim), in lexicographic order (model.md, "Order of hits").
/// Before the first hit it must come before the limit, `best.t`.
pub fn closer<F: Real>(t: F, shape: u32, prim: u32, best: Hit<F>) -> bool {
    let before = shape < best.shape || (shape == best.shape && prim < best.prim);
    t < best.t || (t == best.t && best.shape != NONE && before)
}

/// How the ray starts relative to `shape`.
pub fn start_on<F: Real>(ray: Ray<F>, shape: u32) -> u32 {
    if shape == ray.shape {
        ray.start
    } else {
        START_ELSEWHERE
    }
}
