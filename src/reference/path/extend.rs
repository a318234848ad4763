//! Where a path goes on from a vertex; twin of `extend` in `shaders/path/shade.glsl`.

use super::record::Recorder;
use super::roulette::roulette_survival;
use super::throughput::underflows;
use super::vertex::{Vertex, medium_beyond, same_sides, spawn_ray};
use super::{PathState, SampleId};
use crate::reference::bsdf::{LOBE_DELTA, LOBE_NONE, bsdf_sample, transmission_scale};
use crate::reference::math::Real;
use crate::reference::math::finite::{is_black, is_finite3};
use crate::reference::math::frame::to_world;
use crate::reference::sampler::{bsdf_block, chance, roulette_block, unit_float};
use crate::settings::Settings;

/// Draws the next direction and moves the path onto it; false where the path ends.
pub fn extend<F: Real>(
    settings: &Settings,
    s: &mut PathState<F>,
    v: &Vertex<F>,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
) -> bool {
    let numbers = |block| id.words(settings, block).map(unit_float::<F>);
    let u = numbers(bsdf_block(s.bounce));
    let w = numbers(roulette_block(s.bounce));
    let b = bsdf_sample(
        settings,
        &v.interaction,
        u[0],
        u[1],
        [u[2], u[3]],
        [w[1], w[2]],
    );
    let wi = to_world(v.frame, b.wi);
    let found = b.lobe != LOBE_NONE && same_sides(v, wi, b.wi);
    let faint = underflows(s.throughput, b.weight);
    s.throughput *= b.weight;
    let through = b.wi.z < F::zero();
    if through {
        s.eta_scale *= transmission_scale(settings, v.interaction.eta);
    }
    s.underflow = found && faint;
    let survival = chance(roulette_survival(
        settings.estimator.roulette,
        s.throughput,
        s.eta_scale,
        s.bounce,
    ));
    let survives = w[0] < survival;
    let mut alive = found && survives && !(faint || is_black(s.throughput));
    if alive {
        s.throughput = s.throughput * (F::one() / survival);
    }
    // A broken throughput breaks the sample, which the film then drops and counts.
    if !is_finite3(s.throughput) {
        s.radiance += s.throughput;
        alive = false;
    }
    if alive {
        s.medium = if through { medium_beyond(v) } else { s.medium };
        s.ray = spawn_ray(v, wi, through);
        s.pdf = b.pdf;
        s.delta = b.lobe >= LOBE_DELTA;
        s.bounce += 1;
    }
    recorder.vertex(s, v, b.lobe);
    alive
}
