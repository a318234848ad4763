//! The limits of a device on which a plan depends.

use crate::gpu::{Device, DeviceKind};
use crate::layout::PathState;

/// Also known without a device: by default those of most GPUs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanLimits {
    /// The most bytes in a uniform buffer.
    pub uniform_buffer: u64,
    /// The most bytes in a storage buffer.
    pub storage_buffer: u64,
    /// Pixels processed at once.
    pub tile_pixels: u32,
    /// Whether threads read the unrolled primitives before any branch (`kernel/scene/generate/written_out.rs`).
    pub read_first: bool,
}

impl PlanLimits {
    /// The limits that suit the device.
    pub fn of(device: &Device) -> Self {
        Self {
            uniform_buffer: device.limits().uniform_buffer,
            storage_buffer: device.limits().storage_buffer,
            tile_pixels: tile_pixels(device),
            // A GPU would run out of scalar registers.
            read_first: device.info().kind == DeviceKind::Cpu,
        }
    }
}

impl Default for PlanLimits {
    fn default() -> Self {
        Self {
            uniform_buffer: 1 << 16,
            storage_buffer: 1 << 27,
            tile_pixels: 1 << 20,
            read_first: false,
        }
    }
}

/// A CPU gains from more samples a dispatch, a GPU from more threads; the paths in flight must fit one buffer.
fn tile_pixels(device: &Device) -> u32 {
    let wanted = match device.info().kind {
        DeviceKind::Cpu => 1 << 16,
        _ => 1 << 20,
    };
    let fit = device.limits().storage_buffer / size_of::<PathState>() as u64;
    wanted.min(fit as u32)
}
