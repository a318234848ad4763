//! A rendering on a device by any integrator.

use std::time::Duration;

use crate::features::Features;
use crate::gpu::Device;
use crate::part::Part;
use crate::render::{DispatchLimits, HostFilm, Job, RenderError, SetUp};

/// The kernels and buffers of one integrator, and the film to which they add samples.
pub trait Rendering<'a>: Sized {
    type Film: HostFilm<Scalar = f32>;

    /// Compiles, uploads; no samples yet.
    fn new(
        job: &'a Job<'a>,
        device: &'a Device,
        features: &Features,
        limits: DispatchLimits,
    ) -> Result<Self, RenderError>;

    /// The first dispatch, on which drivers compile; it makes no sample.
    fn compile(&mut self) -> Result<Duration, RenderError>;

    /// Continues a part of the job's picture.
    fn go_on(&mut self, part: Part<f32>) -> Result<(), RenderError>;

    /// Brings every pixel to the sample of index `samples` and reports the part that is done; returns the longest dispatch.
    ///
    /// # Errors
    /// [`RenderError::Loops`] after the first dispatch that did not end its loops itself: later ones would be wrong
    /// too. After this one and any other, the film has the samples that every pixel had by then.
    fn advance(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Duration, RenderError>;

    fn film(&self) -> &Self::Film;

    /// A film of no samples.
    fn empty(&self) -> Self::Film;

    /// Switches to another film, of which no path is in flight, with other random numbers; returns the previous one.
    fn exchange(&mut self, film: Self::Film, seed: u32) -> Result<Self::Film, RenderError>;

    fn costs(&self) -> &Costs;

    /// Names and bytes of all buffers, in the order of their bindings.
    fn buffers(&self) -> Vec<(String, u64)>;
}

/// The cost of a rendering apart from its samples.
#[derive(Clone, Copy, Debug, Default)]
pub struct Costs {
    /// The time that all this took to make, without opening the device.
    pub set_up: SetUp,
    pub spirv_bytes: u64,
    /// The device's own time for all dispatches.
    pub gpu_time: Duration,
}
