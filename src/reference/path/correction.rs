//! Shading normals on light paths; twin of `shaders/path/correction/`.

use super::blocks::Origin;
use super::vertex::Vertex;
use crate::reference::math::frame::to_world;
use crate::reference::math::{Real, Vec3, dot3};

/// `value` for a path from the eye; for a light path [`adjoint_value`].
pub fn corrected<F: Real>(
    from: Origin,
    v: &Vertex<F>,
    wi: Vec3<F>,
    wi_local: Vec3<F>,
    value: Vec3<F>,
) -> Vec3<F> {
    match from {
        Origin::Eye => value,
        Origin::Light => adjoint_value(v, wi, wi_local, value),
    }
}

/// `value` |wo·Ns||wi·Ng|/(|wo·Ng||wi·Ns|): the BSDF of shading normals is not symmetric. `value` has the cosine
/// |wi·Ns| already, or is a weight made with it. 0 where wo's sides differ, as on eye paths; `value` itself where the
/// two normals are equal.
///
/// Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, eq. 5.19.
pub fn adjoint_value<F: Real>(
    v: &Vertex<F>,
    wi: Vec3<F>,
    wi_local: Vec3<F>,
    value: Vec3<F>,
) -> Vec3<F> {
    if v.frame.n == v.facing {
        return value;
    }
    let wo = v.interaction.wo;
    let wo_ng = dot3(to_world(v.frame, wo), v.facing);
    let factor = wo.z * dot3(wi, v.facing).abs() / (wo_ng * wi_local.z.abs());
    if wo.z > F::zero() && wo_ng > F::zero() {
        value * factor
    } else {
        Vec3::zero()
    }
}
