//! A vertex of the path: the surface that a ray has hit, seen from the side it came from.
//! Twin of `shaders/path/vertex.glsl`.

use super::medium::term_attenuation;
use super::throughput::channel_shares;
use super::valid::seen_normal;
use crate::prepared::{NONE, Shape, ShapeKind};
use crate::reference::bsdf::{Interaction, Material, interaction};
use crate::reference::math::frame::{Frame, frame_about, to_local};
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::shape::{Hit, Ray, Surface, triangle_self_distance};
use crate::reference::world::World;
use crate::settings::Settings;

/// A point of a surface, with the data that the path's next steps need.
#[derive(Clone, Copy, Debug)]
pub struct Vertex<F> {
    pub p: Vec3<F>,
    /// Outward geometric normal.
    pub ng: Vec3<F>,
    /// Shading normal on the side of `ng`, as the surface defines it.
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

/// A surface, seen from one side.
pub struct Seen<F> {
    pub outside: bool,
    pub facing: Vec3<F>,
    pub frame: Frame<F>,
    pub interaction: Interaction<F>,
}

/// A surface of normals `ng` and `ns`, seen along `wo`, which leads away from it.
pub fn seen_from<F: Real>(material: Material<F>, ng: Vec3<F>, ns: Vec3<F>, wo: Vec3<F>) -> Seen<F> {
    let outside = dot3(wo, ng) >= F::zero();
    let facing = if outside { ng } else { -ng };
    // The geometric normal decides the side; the shading normal makes only the frame (model.md, "Conventions").
    let shading = if dot3(ns, facing) < F::zero() {
        -ns
    } else {
        ns
    };
    let frame = frame_about(seen_normal(shading, facing, wo, material.kind));
    Seen {
        outside,
        facing,
        frame,
        interaction: interaction(material, outside, to_local(frame, wo), Vec3::one()),
    }
}

/// The point `surface` of a shape, seen along `wo`.
pub fn vertex_at<F: Real>(
    world: &World<F>,
    surface: Surface<F>,
    shape: u32,
    prim: u32,
    wo: Vec3<F>,
) -> Vertex<F> {
    let &Shape { material, kind, .. } = &world.shapes[shape as usize];
    let seen = seen_from(
        world.materials[material as usize],
        surface.ng,
        surface.ns,
        wo,
    );
    Vertex {
        p: surface.p,
        ng: surface.ng,
        ns: surface.ns,
        facing: seen.facing,
        outside: seen.outside,
        frame: seen.frame,
        interaction: seen.interaction,
        shape,
        prim,
        material,
        kind,
    }
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
    let mut v = vertex_at(world, surface, hit.shape, hit.prim, -ray.d);
    let absorption = settings.model.absorption;
    v.interaction.attenuation =
        term_attenuation(world, absorption, v.material, v.outside, distance);
    v.interaction.carried = channel_shares(throughput);
    v
}

/// Whether a direction lies on the same side of the geometric and of the shading normal; elsewhere the BSDF is 0.
pub fn same_sides<F: Real>(facing: Vec3<F>, wi: Vec3<F>, wi_local: Vec3<F>) -> bool {
    (dot3(wi, facing) > F::zero()) == (wi_local.z > F::zero())
}

/// How far along a ray from a mesh its origin's rounding error reaches; solids recognise their own by the side to which
/// the ray leaves.
pub fn self_distance<F: Real>(kind: ShapeKind, p: Vec3<F>, ng: Vec3<F>, d: Vec3<F>) -> F {
    match kind {
        ShapeKind::Mesh => triangle_self_distance(p, ng, d),
        _ => F::zero(),
    }
}

/// The medium behind the surface: the shape's own on entering, air on leaving. Every object is in air.
pub fn medium_beyond<F: Real>(v: &Vertex<F>) -> u32 {
    if v.outside { v.material } else { NONE }
}
