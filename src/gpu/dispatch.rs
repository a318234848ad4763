//! Running a pipeline on buffers.

use std::sync::Arc;
use std::time::Duration;

use ash::vk;

use super::buffer::Buffer;
use super::device::Device;
use super::error::GpuError;
use super::pipeline::{Pipeline, descriptor};
use super::shared_device::SharedDevice;
use crate::layout::BufferUse;

impl Device {
    /// Runs `groups` workgroups and waits for them; returns the device's own time.
    ///
    /// # Errors
    /// [`GpuError::Mismatch`] if buffers, push constants or groups do not match pipeline and device;
    /// [`GpuError::TimeOut`] and [`GpuError::Lost`], after which the device cannot be used any more.
    pub fn dispatch(
        &self,
        pipeline: &Pipeline,
        buffers: &[&Buffer],
        push: &[u8],
        groups: [u32; 3],
    ) -> Result<Duration, GpuError> {
        self.check_dispatch(pipeline, buffers, push, groups)?;
        let mut queue = self.0.queue()?;
        // SAFETY: the set is not in use, because no work is in flight while the queue is locked; the buffers have the
        // types of the layout, and all objects are of this device and outlive the work.
        unsafe {
            pipeline.bind(buffers);
            queue.run(&self.0, |raw, commands| {
                raw.cmd_bind_pipeline(commands, vk::PipelineBindPoint::COMPUTE, pipeline.raw);
                raw.cmd_bind_descriptor_sets(
                    commands,
                    vk::PipelineBindPoint::COMPUTE,
                    pipeline.layout,
                    0,
                    &[pipeline.set],
                    &[],
                );
                if !push.is_empty() {
                    raw.cmd_push_constants(
                        commands,
                        pipeline.layout,
                        vk::ShaderStageFlags::COMPUTE,
                        0,
                        push,
                    );
                }
                raw.cmd_dispatch(commands, groups[0], groups[1], groups[2]);
            })
        }
    }

    fn check_dispatch(
        &self,
        pipeline: &Pipeline,
        buffers: &[&Buffer],
        push: &[u8],
        groups: [u32; 3],
    ) -> Result<(), GpuError> {
        let uses: Vec<BufferUse> = buffers.iter().map(|b| b.usage).collect();
        if uses != pipeline.uses {
            return Err(GpuError::Mismatch(format!(
                "buffers {uses:?}, but the kernel takes {:?}",
                pipeline.uses
            )));
        }
        if push.len() != pipeline.push_bytes as usize {
            let (given, taken) = (push.len(), pipeline.push_bytes);
            return Err(GpuError::Mismatch(format!(
                "{given} bytes of push constants, but the kernel takes {taken}"
            )));
        }
        let limit = self.0.limits.group_count;
        if groups.iter().zip(limit).any(|(g, l)| *g > l) {
            return Err(GpuError::Mismatch(format!(
                "{groups:?} workgroups, but the device allows {limit:?}"
            )));
        }
        let foreign = |d: &Arc<SharedDevice>| !Arc::ptr_eq(d, &self.0);
        if foreign(&pipeline.device) || buffers.iter().any(|b| foreign(&b.device)) {
            return Err(GpuError::Mismatch("an object of another device".into()));
        }
        Ok(())
    }
}

impl Pipeline {
    /// Points the set at `buffers`.
    ///
    /// # Safety
    /// The set is not in use, and the buffers are of the types of its layout.
    unsafe fn bind(&self, buffers: &[&Buffer]) {
        let whole = |b: &&Buffer| {
            [vk::DescriptorBufferInfo {
                buffer: b.raw,
                offset: 0,
                range: vk::WHOLE_SIZE,
            }]
        };
        let infos: Vec<_> = buffers.iter().map(whole).collect();
        let write = |(i, info)| {
            vk::WriteDescriptorSet::default()
                .dst_set(self.set)
                .dst_binding(i as u32)
                .descriptor_type(descriptor(self.uses[i]))
                .buffer_info(info)
        };
        let writes: Vec<_> = infos
            .iter()
            .map(|info| &info[..])
            .enumerate()
            .map(write)
            .collect();
        // SAFETY: of the caller.
        unsafe { self.device.raw.update_descriptor_sets(&writes, &[]) };
    }
}
