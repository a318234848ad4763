//! The next direction of a path at a vertex; twin of `shaders/path/extend.glsl`.

use super::blocks::{Origin, path_block};
use super::correction::corrected;
use super::roulette::roulette_survival;
use super::spawn::spawn_ray;
use super::throughput::underflows;
use super::valid::leaving_direction;
use super::vertex::{Vertex, same_sides};
use super::{SampleId, Subpath};
use crate::reference::bsdf::{BsdfRandom, LOBE_DELTA, LOBE_NONE, bsdf_sample, transmission_scale};
use crate::reference::math::Real;
use crate::reference::math::finite::{is_black, is_finite3};
use crate::reference::math::frame::to_world;
use crate::reference::sampler::{bsdf_block, chance, roulette_block, unit_float};
use crate::settings::Settings;

/// The outcome of an extension.
#[derive(Clone, Copy, Debug)]
pub struct Extension {
    pub alive: bool,
    /// The throughput is below the least that the scalar can represent.
    pub underflow: bool,
    /// The throughput is NaN or infinite.
    pub broken: bool,
    /// `LOBE_…` of the direction.
    pub lobe: u32,
}

/// Draws the next direction and moves the path onto it, if there is one. On a path from a light `settings`
/// are those of the adjoint.
#[inline]
pub fn extend<F: Real>(
    settings: &Settings,
    from: Origin,
    path: &mut Subpath<F>,
    v: &Vertex<F>,
    id: SampleId,
) -> Extension {
    let numbers = |block| {
        id.words(settings, path_block(from, block))
            .map(unit_float::<F>)
    };
    let u = numbers(bsdf_block(path.bounce));
    let w = numbers(roulette_block(path.bounce));
    let random = BsdfRandom {
        lobe: u[0],
        reflect: u[1],
        m: [u[2], u[3]],
        d: [w[1], w[2]],
    };
    let b = bsdf_sample(settings, &v.interaction, random);
    let wi = to_world(v.frame, b.wi);
    let wi = leaving_direction(v.frame.n, v.facing, wi, b.wi.z, b.lobe);
    let found = b.lobe != LOBE_NONE && same_sides(v.facing, wi, b.wi);
    let weight = corrected(from, v, wi, b.wi, b.weight);
    let faint = underflows(path.throughput, weight);
    path.throughput *= weight;
    let through = b.wi.z < F::zero();
    if through {
        path.eta_scale *= transmission_scale(settings, v.interaction.eta);
    }
    let roulette = settings.estimator.roulette;
    let survival = roulette_survival(roulette, path.throughput, path.eta_scale, path.bounce);
    let survival = chance(survival);
    let survives = w[0] < survival;
    let mut alive = found && survives && !(faint || is_black(path.throughput));
    if alive {
        path.throughput = path.throughput * (F::one() / survival);
    }
    let broken = !is_finite3(path.throughput);
    alive = alive && !broken;
    if alive {
        path.ray = spawn_ray(v, wi, through, path.ray.medium);
        path.pdf = b.pdf;
        path.delta = b.lobe >= LOBE_DELTA;
        path.bounce += 1;
    }
    Extension {
        alive,
        underflow: found && faint,
        broken,
        lobe: b.lobe,
    }
}
