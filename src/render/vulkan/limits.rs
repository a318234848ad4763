//! How much one dispatch takes on, and how. The picture does not depend on it.

use std::time::Duration;

use crate::gpu::Device;
use crate::render::plan::PlanLimits;
use crate::render::{DISPATCH_TIME, RenderError};

/// Loop steps a dispatch where the driver sets no limit: enough for some thousand bounces, short of any watchdog.
const UNLIMITED_BUDGET: u32 = 1 << 20;

/// The most that one dispatch takes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DispatchLimits {
    /// Pixels under way at once; 0 counts as 1.
    pub tile_pixels: u32,
    /// Loop steps of a thread after which it hands its path over to the next dispatch; 0 counts as 1.
    pub budget: u32,
    /// Each thread reads primitives that are tried one by one before any branch, as CPU drivers want it
    /// (`kernel/scene/generate/written_out.rs`).
    pub read_first: bool,
    /// Bytes of a buffer, at most: what may lie in several (`render/plan/scene.rs`) does where it is larger.
    pub storage_buffer: u64,
    /// What a dispatch should take.
    pub dispatch_time: Duration,
}

impl DispatchLimits {
    /// What suits the device.
    ///
    /// # Errors
    /// Of the probe for its limit on loops, which runs once a device.
    pub fn of(device: &Device) -> Result<Self, RenderError> {
        let plan = PlanLimits::of(device);
        Ok(Self {
            tile_pixels: plan.tile_pixels,
            budget: budget(device)?,
            read_first: plan.read_first,
            storage_buffer: plan.storage_buffer,
            dispatch_time: DISPATCH_TIME,
        })
    }

    /// What a plan depends on of them, and of the device.
    pub(super) fn plan(self, device: &Device) -> PlanLimits {
        PlanLimits {
            read_first: self.read_first,
            storage_buffer: self.storage_buffer,
            ..PlanLimits::of(device)
        }
    }

    /// A quarter of all that a dispatch takes on.
    pub fn quartered(self) -> Self {
        Self {
            tile_pixels: self.tile_pixels.div_ceil(4),
            budget: self.budget.div_ceil(4),
            dispatch_time: self.dispatch_time / 4,
            ..self
        }
    }
}

/// A driver's limit counts the steps of a whole subgroup, whose threads may in the worst case take turns; half is
/// kept back for the bounce that crosses the line.
fn budget(device: &Device) -> Result<u32, RenderError> {
    Ok(match device.loop_limit()? {
        Some(limit) => limit / device.limits().subgroup / 2,
        None => UNLIMITED_BUDGET,
    })
}
