//! Runs a case: every sample by the device, by cpu-f32 and by cpu-f64.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::case::Case;
use super::picture::Picture;
use vkpt::gpu::Device;
use vkpt::metrics::paired::Comparison;
use vkpt::prepared::{self, PrepareError};
use vkpt::render::{self, Job, KernelChoice, RenderError, Until};
use vkpt::sample::PairedSample;
use vkpt::scene::Errors;

/// Seed of every case: on a CPU driver every run measures the same.
pub const SEED: u32 = 1;

/// Why a case could not run.
#[derive(Debug, thiserror::Error)]
pub enum CheckError {
    #[error("the scene of {0} was refused: {1}")]
    Scene(String, Errors),
    #[error("the scene of {0} was refused: {1}")]
    Prepare(String, PrepareError),
    #[error("{0}: {1}")]
    Render(String, RenderError),
}

/// The measurements of a case.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// The device compared with cpu-f32.
    pub f32: Comparison,
    /// The device compared with cpu-f64.
    pub f64: Comparison,
    /// Samples in which one of the three has a NaN.
    pub nan: u64,
    /// Samples without one in which one of the three has an infinity.
    pub infinite: u64,
    /// Samples in which one of the three has a negative channel.
    pub negative: u64,
    /// The device's brightest channel of a sample.
    pub largest: f64,
    pub energy: Moments,
    /// Hash of the bits of all radiances of the device, in order.
    pub hash: u64,
    pub picture: Picture,
    pub warnings: Vec<String>,
    pub seconds: f64,
    pub interrupted: bool,
}

/// Mean and spread of the samples' radiance, the mean over the channels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moments {
    pub count: u64,
    pub mean: f64,
    /// Σ(x − mean)²
    squares: f64,
}

impl Moments {
    /// Adds a sample (Welford, Technometrics 4(3), 1962).
    pub fn add(&mut self, x: f64) {
        self.count += 1;
        let before = x - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (x - self.mean);
    }

    /// √(s²/n), s² = Σ(x − mean)²/(n − 1). Samples of one pixel are independent, and pixels only add to the spread: no
    /// smaller than the error is.
    pub fn standard_error(&self) -> f64 {
        let n = self.count as f64;
        if n < 2.0 {
            f64::INFINITY
        } else {
            (self.squares / (n - 1.0) / n).sqrt()
        }
    }
}

impl Measured {
    fn add(&mut self, s: &PairedSample) {
        self.f32.add(s.address, &s.device, &s.f32);
        self.f64.add(s.address, &s.device, &s.f64);
        let any = |what: fn(f64) -> bool| {
            [&s.device, &s.f32, &s.f64]
                .iter()
                .any(|p| p.radiance.into_iter().any(what))
        };
        let nan = any(f64::is_nan);
        self.nan += u64::from(nan);
        self.infinite += u64::from(!nan && any(f64::is_infinite));
        self.negative += u64::from(any(|x| x < 0.0));
        self.picture.add(s);
        let radiance = s.device.radiance;
        self.hash = radiance.into_iter().fold(self.hash, hash);
        if radiance.iter().all(|x| x.is_finite()) {
            self.largest = radiance.into_iter().fold(self.largest, f64::max);
            self.energy.add(radiance.iter().sum::<f64>() / 3.0);
        }
    }
}

/// FNV-1a over 64 bits at a time (Fowler, Noll & Vo).
fn hash(hash: u64, x: f64) -> u64 {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0100_0000_01b3;
    let before = if hash == 0 { OFFSET } else { hash };
    (before ^ x.to_bits()).wrapping_mul(PRIME).rotate_left(23)
}

/// Renders the samples of a case on `device` and by both references.
///
/// # Errors
/// A refused scene, or a failing device.
pub fn measure(
    case: &Case,
    device: &Device,
    kernel: KernelChoice,
    stop: &AtomicBool,
) -> Result<Measured, CheckError> {
    let start = Instant::now();
    let name = || case.name.clone();
    let (scene, mut warnings) = case.scene().map_err(|e| CheckError::Scene(name(), e))?;
    let prepared = prepared::prepare(&scene, &case.settings, None)
        .map_err(|e| CheckError::Prepare(name(), e))?;
    warnings.extend(prepared.warnings.iter().cloned());
    let job = Job {
        prepared: &prepared,
        settings: case.settings,
        spp: case.spp,
        until: Until::default(),
        seed: SEED,
        crop: case.crop,
        aovs: &[],
        classes: &[],
        kernel,
    };
    let mut measured = Measured {
        picture: Picture::new(case.crop.unwrap_or([
            0,
            0,
            prepared.camera.width,
            prepared.camera.height,
        ])),
        warnings,
        ..Measured::default()
    };
    let ended = render::paired(&job, device, stop, &mut |_| {}, &mut |s| measured.add(s));
    measured.interrupted = ended.map_err(|e| CheckError::Render(name(), e))?;
    measured.seconds = start.elapsed().as_secs_f64();
    Ok(measured)
}
