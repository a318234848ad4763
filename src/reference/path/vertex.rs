//! A vertex of the path: the surface that a ray has hit, seen from the side it came from.
//! Twin of `shaders/path/vertex.glsl`.

use super::medium::term_attenuation;
use super::throughput::channel_shares;
use super::valid::seen_normal;
use crate::prepared::{NONE, ShapeKind};
use crate::reference::bsdf::{Interaction, bsdf_eval, interaction};
use crate::reference::math::frame::{Frame, frame_about, to_local};
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::shape::{Hit, Ray, triangle_self_distance};
use crate::reference::world::World;
use crate::settings::Settings;

/// A point of a surface, and all that the path's next steps ask of it.
#[derive(Clone, Copy, Debug)]
pub struct Vertex<F> {
    pub p: Vec3<F>,
    /// Outward geometric normal.
    pub ng: Vec3<F>,
    /// Shading normal on the side of `ng`, as the surface has it.
    pub ns: Vec3<F>,
    /// Geometric normal on wo's side.
    pub facing: Vec3<F>,
    /// Whether wo is outside the shape.
    pub outside: bool,
    /// About N', the shading normal on wo's side.
    pub frame: Frame<F>,
    pub interaction: Interaction<F>,
    pub shape: u32,
    pub prim: u32,
    pub material: u32,
    pub kind: ShapeKind,
}

/// The vertex where `ray` has hit, `distance` away from the path's last vertex, with this `throughput`.
pub fn path_vertex<F: Real>(
    world: &World<F>,
    settings: &Settings,
    ray: Ray<F>,
    hit: Hit<F>,
    distance: F,
    throughput: Vec3<F>,
) -> Vertex<F> {
    let surface = world.hit_surface(ray, hit);
    let wo = -ray.d;
    let outside = dot3(wo, surface.ng) >= F::zero();
    let facing = if outside { surface.ng } else { -surface.ng };
    // The geometric normal decides the side; the shading normal makes only the frame (model.md, "Conventions").
    let ns = if dot3(surface.ns, facing) < F::zero() {
        -surface.ns
    } else {
        surface.ns
    };
    let shape = &world.shapes[hit.shape as usize];
    let material = world.materials[shape.material as usize];
    let frame = frame_about(seen_normal(ns, facing, wo, material.kind));
    let attenuation = term_attenuation(
        world,
        settings.model.absorption,
        shape.material,
        outside,
        distance,
    );
    Vertex {
        p: surface.p,
        ng: surface.ng,
        ns: surface.ns,
        facing,
        outside,
        frame,
        interaction: Interaction {
            carried: channel_shares(throughput),
            ..interaction(material, outside, to_local(frame, wo), attenuation)
        },
        shape: hit.shape,
        prim: hit.prim,
        material: shape.material,
        kind: shape.kind,
    }
}

/// Density per solid angle with which a path that comes from `wi` and has lost nothing of its colour would leave `v` towards
/// `wo`; both are of unit length and lead away from it.
pub fn reverse_pdf<F: Real>(settings: &Settings, v: &Vertex<F>, wi: Vec3<F>, wo: Vec3<F>) -> F {
    let outside = dot3(wi, v.ng) >= F::zero();
    let facing = if outside { v.ng } else { -v.ng };
    let ns = if dot3(v.ns, facing) < F::zero() {
        -v.ns
    } else {
        v.ns
    };
    let material = v.interaction.material;
    let frame = frame_about(seen_normal(ns, facing, wi, material.kind));
    let at = interaction(material, outside, to_local(frame, wi), Vec3::one());
    let back = to_local(frame, wo);
    let leaves = (dot3(wo, facing) > F::zero()) == (back.z > F::zero());
    if leaves {
        bsdf_eval(settings, &at, back).pdf
    } else {
        F::zero()
    }
}

/// Whether a direction lies on the same side of the geometric and of the shading normal; elsewhere the BSDF is 0.
pub fn same_sides<F: Real>(v: &Vertex<F>, wi: Vec3<F>, wi_local: Vec3<F>) -> bool {
    (dot3(wi, v.facing) > F::zero()) == (wi_local.z > F::zero())
}

/// How far along a ray from a mesh its origin's rounding error reaches; solids tell theirs by the side that the
/// ray leaves to.
pub fn self_distance<F: Real>(kind: ShapeKind, p: Vec3<F>, ng: Vec3<F>, d: Vec3<F>) -> F {
    match kind {
        ShapeKind::Mesh => triangle_self_distance(p, ng, d),
        _ => F::zero(),
    }
}

/// The medium behind the surface: the shape's own on entering, air on leaving. Every object stands in air.
pub fn medium_beyond<F: Real>(v: &Vertex<F>) -> u32 {
    if v.outside { v.material } else { NONE }
}
