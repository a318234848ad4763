//! Both paths of one sample of bidirectional path tracing, by the reference.

use super::Job;
use crate::reference::integrator::bidirectional::record::Recorder;
use crate::reference::integrator::bidirectional::{Transport, Ways, trace_bidirectional};
use crate::reference::integrator::light::Splat;
use crate::reference::math::{Real, Vec3};
use crate::reference::path::SampleId;
use crate::reference::world::World;

/// The light that a sample's paths contribute.
pub struct Brought<F> {
    /// By the eye path, W·sr⁻¹·m⁻².
    pub radiance: Vec3<F>,
    /// By the light path, in the order of its vertices, anywhere in the picture.
    pub splats: Vec<Splat<F>>,
}

/// Follows the paths of a sample.
pub fn both_paths<F: Real>(
    job: &Job,
    world: &World<F>,
    id: SampleId,
    recorder: &mut impl Recorder<F>,
) -> Brought<F> {
    let adjoint = job.settings.adjoint();
    let transport = Transport {
        world,
        settings: &job.settings,
        adjoint: &adjoint,
        ways: Ways::All,
    };
    let mut splats = Vec::new();
    let take = &mut |splat| splats.push(splat);
    let (radiance, _) = trace_bidirectional(transport, job.whole().window(), id, recorder, take);
    Brought {
        radiance: radiance.unwrap_or(Vec3::zero()),
        splats,
    }
}
