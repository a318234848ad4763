//! `--aov light:…`: the light of a picture by classes of paths.

mod agree;
mod closed_forms;
mod patterns;
mod sums;

use std::sync::atomic::AtomicBool;

use vkpt::film::Channel;
use vkpt::path_class::PathClass;
use vkpt::render::{Job, light_classes};
use vkpt::settings::{Integrator, Settings};

pub const INTEGRATORS: [Integrator; 3] = [
    Integrator::Path,
    Integrator::Light,
    Integrator::Bidirectional,
];

pub fn settings(integrator: Integrator, max_depth: Option<u32>) -> Settings {
    let mut settings = Settings::default();
    settings.estimator.integrator = integrator;
    settings.model.max_depth = max_depth;
    settings
}

pub fn class(pattern: &str) -> PathClass {
    PathClass::new(pattern).unwrap_or_else(|e| panic!("{e}"))
}

pub fn classes(patterns: &[&str]) -> Vec<PathClass> {
    patterns.iter().map(|pattern| class(pattern)).collect()
}

/// The light of each class of the job's picture, pixel by pixel.
pub fn split(job: &Job, patterns: &[&str]) -> Vec<Vec<[f32; 3]>> {
    let classes = classes(patterns);
    let job = Job {
        classes: &classes,
        ..*job
    };
    let channels = light_classes(&job, job.spp, &AtomicBool::new(false), &mut |_| {});
    let channels = channels.expect("nobody stops it");
    assert_eq!(channels.len(), 3 * patterns.len());
    channels.chunks(3).map(pixels).collect()
}

fn pixels(rgb: &[Channel]) -> Vec<[f32; 3]> {
    let [r, g, b] = [0, 1, 2].map(|i| rgb[i].values.iter());
    r.zip(g).zip(b).map(|((r, g), b)| [*r, *g, *b]).collect()
}
