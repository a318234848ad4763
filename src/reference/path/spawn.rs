//! The ray that leaves a vertex; twin of `shaders/path/spawn.glsl`.

use super::vertex::{Vertex, medium_beyond, self_distance};
use crate::reference::math::{Real, Vec3};
use crate::reference::shape::{FAR, Ray, START_INSIDE, START_OUTSIDE};

/// Along `wi`, through the surface or not, by a path that has come through `medium`.
pub fn spawn_ray<F: Real>(v: &Vertex<F>, wi: Vec3<F>, through: bool, medium: u32) -> Ray<F> {
    let goes_outside = v.outside != through;
    Ray {
        o: v.p,
        t_max: F::new(FAR),
        d: wi,
        shape: v.shape,
        prim: v.prim,
        start: if goes_outside {
            START_OUTSIDE
        } else {
            START_INSIDE
        },
        t_self: self_distance(v.kind, v.p, v.ng, wi),
        medium: if through { medium_beyond(v) } else { medium },
    }
}
