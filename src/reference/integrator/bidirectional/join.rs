//! A vertex of the eye path joined to one of the light path; twin of `shaders/integrator/bidirectional/join.glsl`.

use super::Transport;
use super::bend::bend;
use super::joint::Joint;
use super::partial::vertex_weight;
use crate::reference::math::finite::is_black;
use crate::reference::math::{Real, Vec3, length3};
use crate::reference::path::blocks::Origin;
use crate::reference::path::spawn::spawn_ray;
use crate::reference::path::trace::ShadowRay;
use crate::reference::path::vertex::{Vertex, medium_beyond};
use crate::reference::shape::{Ray, Target};

/// A connection to be traced, and the medium in which it must arrive.
#[derive(Clone, Copy, Debug)]
pub struct Connection<F> {
    pub shadow: ShadowRay<F>,
    pub medium: u32,
}

/// The light that may arrive at the eye via `y`, on the light path, and `x`, on the eye path: f_x f_y/d² times the
/// throughput and power that they carry, for `share` vertices like `y`. `None` where they cannot be connected.
pub fn join<F: Real>(
    t: Transport<F>,
    x: &Joint<F>,
    y: &Joint<F>,
    share: F,
) -> Option<Connection<F>> {
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
    let at_x = bend(t.settings, Origin::Eye, &x.v, x.wo, wi)?;
    let at_y = bend(t.adjoint, Origin::Light, &y.v, y.wo, -wi)?;
    let weight = vertex_weight(x.partial, at_x.junction, y.partial, at_y.junction, distance);
    let weight = t.ways.weight(y.count, x.count, weight);
    let over_square = weight / (distance * distance) * share;
    let contribution = x.carried * at_x.f * (y.carried * at_y.f) * over_square;
    if is_black(contribution) {
        return None;
    }
    // A target is a whole solid, which cannot hide its own inside from a ray that comes from outside: such a ray goes
    // the other way, and meets the solid's far side.
    let (of_x, of_y) = (at_x.through, at_y.through);
    Some(if looks_inside(&y.v, of_y) {
        connection(y, -wi, of_y, x, of_x, distance, contribution)
    } else {
        connection(x, wi, of_x, y, of_y, distance, contribution)
    })
}

/// Whether a direction leads into the solid that the vertex is on.
fn looks_inside<F: Real>(v: &Vertex<F>, through: bool) -> bool {
    v.outside == through
}

/// The connection along `wi`, the direction in which `from` sees `to`: it must arrive in the medium that `to` faces.
fn connection<F: Real>(
    from: &Joint<F>,
    wi: Vec3<F>,
    through: bool,
    to: &Joint<F>,
    to_through: bool,
    distance: F,
    contribution: Vec3<F>,
) -> Connection<F> {
    let shadow = ShadowRay {
        ray: Ray {
            t_max: distance,
            ..spawn_ray(&from.v, wi, through, from.medium)
        },
        target: Target {
            shape: to.v.shape,
            prim: to.v.prim,
        },
        contribution,
    };
    let medium = match to_through {
        true => medium_beyond(&to.v),
        false => to.medium,
    };
    Connection { shadow, medium }
}
