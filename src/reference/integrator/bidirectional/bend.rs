//! The scattering at a vertex where a path is joined, and its densities from either side; twin of
//! `shaders/integrator/bidirectional/bend.glsl`.

use super::partial::{Junction, Partial, scatter, scatter_delta};
use crate::reference::bsdf::bsdf_eval;
use crate::reference::math::finite::is_black;
use crate::reference::math::frame::to_local;
use crate::reference::math::{Real, Vec3, dot3};
use crate::reference::path::Subpath;
use crate::reference::path::blocks::Origin;
use crate::reference::path::correction::corrected;
use crate::reference::path::vertex::{Vertex, same_sides, seen_from};
use crate::settings::Settings;

/// One end of a connection.
#[derive(Clone, Copy, Debug)]
pub struct Bend<F> {
    /// Value · cosine.
    pub f: Vec3<F>,
    pub junction: Junction<F>,
    /// The connection leads through the surface.
    pub through: bool,
}

/// Density per solid angle with which a path that comes from `wi`, with grey throughput, would leave `v` towards `wo`;
/// both are of unit length and lead away from it.
pub fn reverse_pdf<F: Real>(settings: &Settings, v: &Vertex<F>, wi: Vec3<F>, wo: Vec3<F>) -> F {
    let seen = seen_from(v.interaction.material, v.ng, v.ns, wi);
    let back = to_local(seen.frame, wo);
    if same_sides(seen.facing, wo, back) {
        bsdf_eval(settings, &seen.interaction, back).pdf
    } else {
        F::zero()
    }
}

/// The scattering at `v` of a path that began at `from` and came along `wo`, in the direction `wi`; `settings` are
/// those of its end. `None` where no light goes that way.
pub fn bend<F: Real>(
    settings: &Settings,
    from: Origin,
    v: &Vertex<F>,
    wo: Vec3<F>,
    wi: Vec3<F>,
) -> Option<Bend<F>> {
    let local = to_local(v.frame, wi);
    let value = bsdf_eval(settings, &v.interaction, local);
    let f = corrected(from, v, wi, local, value.value);
    let valid = same_sides(v.facing, wi, local) && !is_black(f);
    valid.then(|| Bend {
        f,
        junction: Junction {
            cosine: dot3(wi, v.ng).abs(),
            pdf: value.pdf,
            reverse_pdf: reverse_pdf(settings, v, wi, wo),
        },
        through: local.z < F::zero(),
    })
}

/// The quantities of the weights along the direction in which a path has just left `v`; `settings` are those of its end.
pub fn left_partial<F: Real>(
    settings: &Settings,
    path: &Subpath<F>,
    v: &Vertex<F>,
    wo: Vec3<F>,
    at: Partial<F>,
) -> Partial<F> {
    let wi = path.ray.d;
    let cosine = dot3(wi, v.ng).abs();
    if path.delta {
        return scatter_delta(at, cosine);
    }
    let to = Junction {
        cosine,
        pdf: path.pdf,
        reverse_pdf: reverse_pdf(settings, v, wi, wo),
    };
    scatter(at, to)
}
