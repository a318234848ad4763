//! A rendering on a device that may fail: it is then continued on the device opened again.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::vulkan::{self, Failed};
use super::{DispatchLimits, End, Job, Outcome, RenderError, Start, Watch};
use crate::gpu::{Device, Selector};

/// Renders from `start` on. Once the device fails, continues with dispatches a quarter as long; once it fails again,
/// ends with [`End::Lost`].
///
/// # Errors
/// Those that another attempt would not avoid; [`RenderError::Twice`] if no pixel has a sample.
pub fn render(
    job: &Job,
    selector: &Selector,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, RenderError> {
    let whole = |limits| limits;
    let first = match attempt(job, selector, whole, start, stop, watch) {
        Err(failed) if failed.error.is_loss() => failed,
        ended => return ended.map_err(|failed| failed.error),
    };
    watch.lost(
        &first.error,
        "it is reopened, and the rendering continues with shorter dispatches",
    );
    let state = first.so_far.as_ref().map(|so_far| so_far.state.clone());
    let start = state.map_or_else(|| start.clone(), Start::After);
    let quarter = DispatchLimits::quartered;
    let second = match attempt(job, selector, quarter, &start, stop, watch) {
        Ok(outcome) => return Ok(outcome),
        Err(failed) => failed,
    };
    let so_far = second.so_far.or(first.so_far);
    match so_far.filter(|so_far| so_far.spp > 0) {
        None => Err(RenderError::Twice(Box::new(second.error))),
        Some(so_far) => Ok(Outcome {
            end: End::Lost,
            failure: Some(second.error.to_string()),
            ..*so_far
        }),
    }
}

/// Renders on the device opened again.
fn attempt(
    job: &Job,
    selector: &Selector,
    limits: impl Fn(DispatchLimits) -> DispatchLimits,
    start: &Start,
    stop: &AtomicBool,
    watch: &mut dyn Watch,
) -> Result<Outcome, Failed> {
    let began = Instant::now();
    let device = Device::open(selector)?;
    let limits = limits(DispatchLimits::of(&device)?);
    let opened = began.elapsed().as_secs_f64();
    let mut outcome = vulkan::render(job, &device, limits, start, stop, watch)?;
    outcome.stats.set_up.device = opened;
    Ok(outcome)
}
