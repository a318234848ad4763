//! Probes whether the driver finishes its loops.

use super::device::Device;
use super::error::GpuError;
use crate::kernel::{Composer, compile};
use crate::layout::BufferUse;

/// Steps of the probe. Mesa 22's lavapipe silently ends all loops of a subgroup after 65,535 in one dispatch.
const GOAL: u32 = 200_000;

impl Device {
    /// Loop steps that a subgroup may take in one dispatch, all its loops together; `None`: no limit was found.
    /// The first call runs a small kernel.
    pub fn loop_limit(&self) -> Result<Option<u32>, GpuError> {
        if let Some(limit) = self.0.loop_limit.get() {
            return Ok(*limit);
        }
        let kernel = compile(&Composer::new().compose(&["probe/loop_limit.comp"])?)?;
        let pipeline = self.pipeline(&kernel, &[BufferUse::Storage], 0)?;
        let words = self.buffer("loop probe", BufferUse::Storage, 12)?;
        words.write(&GOAL.to_le_bytes())?;
        self.dispatch(&pipeline, &[&words], &[], [1, 1, 1])?;
        let mut bytes = [0; 8];
        words.read_into(&mut bytes)?;
        let [_, _, _, _, count @ ..] = bytes;
        let count = u32::from_le_bytes(count);
        let limit = (count < GOAL).then_some(count);
        Ok(*self.0.loop_limit.get_or_init(|| limit))
    }
}
