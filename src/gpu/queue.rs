//! Work, one piece at a time: record, submit, wait, report its duration.

use std::time::{Duration, Instant};

use ash::vk;

use super::barrier;
use super::error::GpuError;
use super::shared_device::SharedDevice;

/// A compute queue with a command buffer, two timestamps and, after the first work, a fence.
pub(super) struct Queue {
    raw: vk::Queue,
    pool: vk::CommandPool,
    commands: vk::CommandBuffer,
    fence: vk::Fence,
    queries: vk::QueryPool,
    /// Valid bits of a timestamp; 0 if the queue has none.
    timestamp_bits: u32,
}

impl Queue {
    pub fn new(device: &ash::Device, family: u32, timestamp_bits: u32) -> Result<Self, GpuError> {
        // SAFETY: `device` was created with one queue of `family`.
        let raw = unsafe { device.get_device_queue(family, 0) };
        let mut queue = Self {
            raw,
            pool: vk::CommandPool::null(),
            commands: vk::CommandBuffer::null(),
            fence: vk::Fence::null(),
            queries: vk::QueryPool::null(),
            timestamp_bits,
        };
        queue.fill(device, family).inspect_err(|_| {
            // SAFETY: nothing was submitted; null handles are ignored.
            unsafe { queue.destroy(device) }
        })?;
        Ok(queue)
    }

    fn fill(&mut self, device: &ash::Device, family: u32) -> Result<(), GpuError> {
        let pool = vk::CommandPoolCreateInfo::default()
            .queue_family_index(family)
            .flags(vk::CommandPoolCreateFlags::RESET_COMMAND_BUFFER);
        let queries = vk::QueryPoolCreateInfo::default()
            .query_type(vk::QueryType::TIMESTAMP)
            .query_count(2);
        // SAFETY: each create info is complete and the device alive.
        unsafe {
            self.pool = device
                .create_command_pool(&pool, None)
                .map_err(GpuError::of("vkCreateCommandPool"))?;
            let one = vk::CommandBufferAllocateInfo::default()
                .command_pool(self.pool)
                .command_buffer_count(1);
            self.commands = device
                .allocate_command_buffers(&one)
                .map_err(GpuError::of("vkAllocateCommandBuffers"))?[0];
            self.queries = device
                .create_query_pool(&queries, None)
                .map_err(GpuError::of("vkCreateQueryPool"))?;
        }
        Ok(())
    }

    /// # Safety
    /// The queue must be idle, and not be used again.
    pub unsafe fn destroy(&mut self, device: &ash::Device) {
        // SAFETY: of the caller; null handles are ignored.
        unsafe {
            device.destroy_query_pool(self.queries, None);
            device.destroy_fence(self.fence, None);
            device.destroy_command_pool(self.pool, None);
        }
    }

    /// Runs the commands that `record` records, between barriers, and waits for them. Returns the device's own time.
    ///
    /// # Safety
    /// `record` must record valid commands for a compute queue, on objects of `device` that live until this returns.
    pub unsafe fn run(
        &mut self,
        device: &SharedDevice,
        record: impl FnOnce(&ash::Device, vk::CommandBuffer),
    ) -> Result<Duration, GpuError> {
        let (raw, commands) = (&device.raw, self.commands);
        let begin = vk::CommandBufferBeginInfo::default()
            .flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
        // SAFETY: the guard of the mutex makes this the only user of the queue, and the last work was waited for.
        unsafe {
            raw.begin_command_buffer(commands, &begin)
                .map_err(GpuError::of("vkBeginCommandBuffer"))?;
            barrier::before(raw, commands);
            self.timestamp(raw, 0);
            record(raw, commands);
            self.timestamp(raw, 1);
            barrier::after(raw, commands);
            raw.end_command_buffer(commands)
                .map_err(GpuError::of("vkEndCommandBuffer"))?;
            let started = Instant::now();
            self.submit_and_wait(device)?;
            let host_time = started.elapsed();
            Ok(self.elapsed(device)?.unwrap_or(host_time))
        }
    }

    /// # Safety
    /// As of [`run`](Self::run), the commands recorded.
    unsafe fn submit_and_wait(&mut self, device: &SharedDevice) -> Result<(), GpuError> {
        self.make_fence(&device.raw)?;
        let commands = [self.commands];
        let submits = [vk::SubmitInfo::default().command_buffers(&commands)];
        let patience = device.options.patience;
        let nanoseconds = patience.as_nanos().try_into().unwrap_or(u64::MAX);
        // SAFETY: the fence is unsignalled and not in use.
        unsafe {
            device
                .raw
                .queue_submit(self.raw, &submits, self.fence)
                .map_err(GpuError::of("vkQueueSubmit"))?;
            device
                .raw
                .wait_for_fences(&[self.fence], true, nanoseconds)
                .map_err(|result| match result {
                    vk::Result::TIMEOUT => GpuError::TimeOut(patience),
                    result => GpuError::of("vkWaitForFences")(result),
                })
                // The device may still be working on it.
                .inspect_err(|error| device.give_up(error))?;
            if device.raw.reset_fences(&[self.fence]).is_err() {
                // It stays signalled, so the next work would be taken for done: it gets its own fence.
                device.raw.destroy_fence(self.fence, None);
                self.fence = vk::Fence::null();
            }
        }
        Ok(())
    }

    /// # Safety
    /// While recording; 0 before 1.
    unsafe fn timestamp(&self, raw: &ash::Device, index: u32) {
        if self.timestamp_bits == 0 {
            return;
        }
        let stage = [
            vk::PipelineStageFlags::TOP_OF_PIPE,
            vk::PipelineStageFlags::BOTTOM_OF_PIPE,
        ][index as usize];
        // SAFETY: of the caller; the pool has two queries.
        unsafe {
            if index == 0 {
                raw.cmd_reset_query_pool(self.commands, self.queries, 0, 2);
            }
            raw.cmd_write_timestamp(self.commands, stage, self.queries, index);
        }
    }

    /// With the first work: a driver that only compiles (radv's null hardware) has no fences.
    fn make_fence(&mut self, device: &ash::Device) -> Result<(), GpuError> {
        if self.fence == vk::Fence::null() {
            // SAFETY: the create info is complete and the device alive.
            self.fence = unsafe { device.create_fence(&Default::default(), None) }
                .map_err(GpuError::of("vkCreateFence"))?;
        }
        Ok(())
    }

    /// Time between the two timestamps, `None` if the queue has none or they cannot be read: the work is done all the same.
    ///
    /// # Safety
    /// The commands with both timestamps have been executed.
    unsafe fn elapsed(&self, device: &SharedDevice) -> Result<Option<Duration>, GpuError> {
        if self.timestamp_bits == 0 {
            return Ok(None);
        }
        let mut ticks = [0u64; 2];
        let flags = vk::QueryResultFlags::TYPE_64 | vk::QueryResultFlags::WAIT;
        // SAFETY: of the caller.
        let waited = unsafe {
            device
                .raw
                .get_query_pool_results(self.queries, 0, &mut ticks, flags)
        };
        match waited {
            Ok(()) => (),
            Err(vk::Result::ERROR_DEVICE_LOST) => return Err(GpuError::Lost),
            Err(_) => return Ok(None),
        }
        let mask = u64::MAX >> (64 - self.timestamp_bits.min(64));
        let elapsed = ticks[1].wrapping_sub(ticks[0]) & mask;
        let nanoseconds = elapsed as f64 * f64::from(device.limits.timestamp_period);
        Ok(Some(Duration::from_nanos(nanoseconds as u64)))
    }
}
