//! A vertex of the eye path joined to one of the light path.

use super::Transport;
use super::partial::{Junction, Partial, vertex_weight};
use super::reservoir::LightVertex;
use crate::reference::bsdf::bsdf_eval;
use crate::reference::math::finite::is_black;
use crate::reference::math::frame::to_local;
use crate::reference::math::{Real, Vec3, dot3, length3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::correction::corrected;
use crate::reference::path::spawn::spawn_ray;
use crate::reference::path::trace::{ShadowRay, shadow_ray_into};
use crate::reference::path::vertex::{Vertex, medium_beyond, reverse_pdf, same_sides};
use crate::reference::shape::{Ray, Target};
use crate::settings::Settings;

/// One end of a connection.
#[derive(Clone, Copy, Debug)]
pub struct Joint<'a, F> {
    pub v: &'a Vertex<F>,
    /// Whence its path came, of unit length.
    pub wo: Vec3<F>,
    /// Throughput, or power.
    pub carried: Vec3<F>,
    /// The medium that its path came through.
    pub medium: u32,
    pub partial: Partial<F>,
    /// Vertices of its path up to this one.
    pub count: u32,
}

impl<F: Real> LightVertex<F> {
    /// As an end of a connection.
    pub fn joint(&self) -> Joint<'_, F> {
        Joint {
            v: &self.v,
            wo: self.wo,
            carried: self.power,
            medium: self.medium,
            partial: self.partial,
            count: self.count,
        }
    }
}

/// What a path does at one end, in the direction `wi` of the other.
struct Bend<F> {
    /// Value · cosine.
    f: Vec3<F>,
    junction: Junction<F>,
    through: bool,
}

fn bend<F: Real>(settings: &Settings, from: Origin, at: &Joint<F>, wi: Vec3<F>) -> Option<Bend<F>> {
    let local = to_local(at.v.frame, wi);
    let value = bsdf_eval(settings, &at.v.interaction, local);
    let f = corrected(from, at.v, wi, local, value.value);
    let valid = same_sides(at.v, wi, local) && !is_black(f);
    valid.then(|| Bend {
        f,
        junction: Junction {
            cosine: dot3(wi, at.v.ng).abs(),
            pdf: value.pdf,
            reverse_pdf: reverse_pdf(settings, at.v, wi, at.wo),
        },
        through: local.z < F::zero(),
    })
}

/// What arrives at the eye by way of `y`, on the light path, and `x`, on the eye path: f_x f_y/d² times what both carry;
/// `None` where they do not see each other, or look into different media.
pub fn join<F: Real>(
    t: Transport<F>,
    x: &Joint<F>,
    y: &Joint<F>,
    rays: &mut u64,
) -> Option<Vec3<F>> {
    // A path of n bounces has n + 2 vertices.
    let count = x.count + y.count;
    if t.settings.model.max_depth.is_some_and(|n| count > n + 2) {
        return None;
    }
    let to = y.v.p - x.v.p;
    let distance = length3(to);
    if distance <= F::zero() {
        return None;
    }
    let wi = to / distance;
    let at_x = bend(t.settings, Origin::Eye, x, wi)?;
    let at_y = bend(t.adjoint, Origin::Light, y, -wi)?;
    let weight = vertex_weight(x.partial, at_x.junction, y.partial, at_y.junction, distance);
    let weight = t.ways.weight(y.count, x.count, weight);
    let contribution = x.carried * at_x.f * (y.carried * at_y.f) * (weight / (distance * distance));
    if is_black(contribution) {
        return None;
    }
    let (from, to) = ((x, wi, at_x.through), (y, -wi, at_y.through));
    // A target is a whole solid, which cannot hide its own inside from a ray that comes from without: such a ray goes the other
    // way, and meets the solid's far side.
    let (from, to) = if looks_inside(y.v, at_y.through) {
        (to, from)
    } else {
        (from, to)
    };
    arrives(t, from, to, distance, contribution, rays)
}

/// Whether a direction leads into the solid that the vertex is on.
fn looks_inside<F: Real>(v: &Vertex<F>, through: bool) -> bool {
    v.outside == through
}

/// A connection's end, the direction of the other, and whether that leads through the surface.
type End<'a, F> = (&'a Joint<'a, F>, Vec3<F>, bool);

/// What is left of `contribution` on the way between two ends, if they look into the same medium.
fn arrives<F: Real>(
    t: Transport<F>,
    (from, wi, through): End<F>,
    (to, _, to_through): End<F>,
    distance: F,
    contribution: Vec3<F>,
    rays: &mut u64,
) -> Option<Vec3<F>> {
    let shadow = ShadowRay {
        ray: Ray {
            t_max: distance,
            ..spawn_ray(from.v, wi, through, from.medium)
        },
        target: Target {
            shape: to.v.shape,
            prim: to.v.prim,
        },
        contribution,
    };
    let medium = match to_through {
        true => medium_beyond(to.v),
        false => to.medium,
    };
    let (light, arrived_in) = shadow_ray_into(t.world, t.settings, shadow, rays)?;
    (arrived_in == medium).then_some(light)
}
