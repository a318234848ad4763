//! A scene's buffers on a device, as planned.

use crate::flat;
use crate::gpu::{Buffer, BufferUse, Device};
use crate::prepared::Prepared;
use crate::render::RenderError;
use crate::render::plan::{CAMERA, ScenePlan};

/// The buffers of one scene, in the order of their bindings.
pub struct SceneBuffers {
    buffers: Vec<Buffer>,
    uses: Vec<BufferUse>,
}

impl SceneBuffers {
    /// Uploads the planned arrays, and nothing else.
    pub fn new(device: &Device, plan: &ScenePlan) -> Result<Self, RenderError> {
        let mut buffers = Vec::new();
        for array in plan.arrays() {
            let binding = array.plan.binding;
            let buffer = device.buffer(binding.name, binding.buffer_use, array.plan.bytes)?;
            buffer.write(array.content().bytes())?;
            buffers.push(buffer);
        }
        Ok(Self {
            buffers,
            uses: plan.uses(),
        })
    }

    /// Makes the kernel draw other random numbers from now on.
    pub fn reseed(&self, prepared: &Prepared, seed: u32) -> Result<(), RenderError> {
        let camera = self.buffers.iter().find(|b| b.name() == CAMERA);
        let record = flat::camera(prepared, seed);
        camera.map_or(Ok(()), |camera| {
            Ok(camera.write(bytemuck::bytes_of(&record))?)
        })
    }

    pub fn uses(&self) -> Vec<BufferUse> {
        self.uses.clone()
    }

    pub fn buffers(&self) -> Vec<&Buffer> {
        self.buffers.iter().collect()
    }
}
