//! Limits of one dispatch. The picture does not depend on them.

use std::time::Duration;

use crate::gpu::Device;
use crate::render::plan::PlanLimits;
use crate::render::{DISPATCH_TIME, RenderError};

/// Loop steps a dispatch if the driver sets no limit: enough for some thousand bounces, short of any watchdog.
const UNLIMITED_BUDGET: u32 = 1 << 20;

/// The most work of one dispatch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DispatchLimits {
    /// Pixels processed at once; 0 counts as 1.
    pub tile_pixels: u32,
    /// Loop steps of a thread after which it leaves its path to the next dispatch; 0 counts as 1.
    pub budget: u32,
    /// Each thread reads the unrolled primitives before any branch, which CPU drivers need
    /// (`kernel/scene/generate/written_out.rs`).
    pub read_first: bool,
    /// The most bytes of a buffer: larger arrays are split, if they can be (`render/plan/scene.rs`).
    pub storage_buffer: u64,
    /// The target duration of a dispatch.
    pub dispatch_time: Duration,
}

impl DispatchLimits {
    /// The limits that suit the device.
    ///
    /// # Errors
    /// Those of the probe for its limit on loops, which runs once a device.
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

    /// The limits of a plan, from these and the device.
    pub(super) fn plan(self, device: &Device) -> PlanLimits {
        PlanLimits {
            read_first: self.read_first,
            storage_buffer: self.storage_buffer,
            ..PlanLimits::of(device)
        }
    }

    /// A quarter of the work of a dispatch.
    pub fn quartered(self) -> Self {
        Self {
            tile_pixels: self.tile_pixels.div_ceil(4),
            budget: self.budget.div_ceil(4),
            dispatch_time: self.dispatch_time / 4,
            ..self
        }
    }
}

/// A driver's limit counts the steps of a whole subgroup, whose threads may in the worst case alternate; half is
/// reserved for the bounce that exceeds the budget.
fn budget(device: &Device) -> Result<u32, RenderError> {
    Ok(match device.loop_limit()? {
        Some(limit) => limit / device.limits().subgroup / 2,
        None => UNLIMITED_BUDGET,
    })
}
