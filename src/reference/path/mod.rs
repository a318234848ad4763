//! Paths and how they travel, from either end; twin of `shaders/path/`.

pub mod blocks;
pub mod correction;
pub mod extend;
pub mod medium;
pub mod roulette;
pub mod spawn;
pub mod throughput;
pub mod trace;
pub mod valid;
pub mod vertex;

use super::math::Vec3;
use super::sampler::sampler_block;
use super::shape::Ray;
use crate::settings::Settings;

/// Selects the random numbers of a path.
#[derive(Clone, Copy, Debug)]
pub struct SampleId {
    pub column: u32,
    /// Counted from the top.
    pub row: u32,
    /// row · width + column of the full picture.
    pub pixel: u32,
    pub sample: u32,
    pub seed: u32,
}

impl SampleId {
    /// The four words of a block of [`sampler::dimensions`](super::sampler::dimensions).
    pub fn words(self, settings: &Settings, block: u32) -> [u32; 4] {
        let sampler = settings.estimator.sampler;
        sampler_block(sampler, self.pixel, self.sample, block, self.seed)
    }
}

/// The state that passes from one vertex to the next.
#[derive(Clone, Copy, Debug)]
pub struct Subpath<F> {
    /// The next ray.
    pub ray: Ray<F>,
    pub throughput: Vec3<F>,
    /// Product of the eta² that radiance scaling has put into `throughput`.
    pub eta_scale: F,
    /// Density of the ray's direction; meaningless where `delta` is set.
    pub pdf: F,
    /// The ray comes from the camera or from a delta lobe.
    pub delta: bool,
    pub bounce: u32,
}

/// Whether a path ends after this many bounces; never without a `--max-depth`.
pub fn depth_reached(settings: &Settings, bounce: u32) -> bool {
    settings.model.max_depth.is_some_and(|n| bounce >= n)
}
