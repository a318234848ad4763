//! Buffers, each with its own memory.

use std::ptr::NonNull;
use std::sync::{Arc, PoisonError};

use ash::vk;

use super::device::Device;
use super::error::GpuError;
use super::memory::{kinds_of_memory, stages};
use super::shared_device::SharedDevice;
use crate::layout::BufferUse;

/// Device memory with a name, initially zero.
pub struct Buffer {
    pub(super) device: Arc<SharedDevice>,
    pub(super) name: String,
    pub(super) usage: BufferUse,
    pub(super) bytes: u64,
    pub(super) raw: vk::Buffer,
    pub(super) memory: vk::DeviceMemory,
    pub(super) heap: usize,
    /// Bytes taken from the heap.
    pub(super) size: u64,
    /// The first byte, if the host sees it.
    pub(super) mapped: Option<NonNull<u8>>,
}

// SAFETY: `mapped` is only followed while the queue's lock is held; handles may be used from any thread.
unsafe impl Send for Buffer {}
// SAFETY: as above.
unsafe impl Sync for Buffer {}

impl Device {
    /// A buffer of `bytes` bytes, zeros.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`], before anything is allocated, if `bytes` is more than the device allows for this use or
    /// than its memory has left.
    pub fn buffer(
        &self,
        name: impl Into<String>,
        usage: BufferUse,
        bytes: u64,
    ) -> Result<Buffer, GpuError> {
        let name = name.into();
        let (limit, what) = match usage {
            BufferUse::Uniform => (
                self.0.limits.uniform_buffer,
                "the device's limit for a uniform buffer",
            ),
            BufferUse::Storage => (
                self.0.limits.storage_buffer,
                "the device's limit for a storage buffer",
            ),
        };
        if bytes > limit {
            return Err(GpuError::TooLarge {
                name,
                bytes,
                limit,
                what,
            });
        }
        let kind = match usage {
            BufferUse::Uniform => vk::BufferUsageFlags::UNIFORM_BUFFER,
            BufferUse::Storage => vk::BufferUsageFlags::STORAGE_BUFFER,
        };
        let flags = kind | vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
        let buffer = Buffer::new(
            &self.0,
            name,
            usage,
            bytes,
            flags,
            &kinds_of_memory(&self.0),
            !stages(&self.0),
        )?;
        buffer.clear()?;
        Ok(buffer)
    }
}

impl Buffer {
    /// Without zeros. Buffers of 0 bytes are legal here, but not in Vulkan, so it takes at least 16.
    pub(super) fn new(
        device: &Arc<SharedDevice>,
        name: String,
        usage: BufferUse,
        bytes: u64,
        flags: vk::BufferUsageFlags,
        kinds: &[vk::MemoryPropertyFlags],
        map: bool,
    ) -> Result<Self, GpuError> {
        let info = vk::BufferCreateInfo::default()
            .size(bytes.next_multiple_of(4).max(16))
            .usage(flags);
        // SAFETY: the info is complete; sizes above the limits were refused.
        let raw = unsafe { device.raw.create_buffer(&info, None) }
            .map_err(GpuError::of("vkCreateBuffer"))?;
        let mut buffer = Self {
            device: device.clone(),
            name,
            usage,
            bytes,
            raw,
            memory: vk::DeviceMemory::null(),
            heap: 0,
            size: 0,
            mapped: None,
        };
        buffer.allocate(kinds, map)?;
        Ok(buffer)
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// The requested size.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        if self.device.is_abandoned() {
            return;
        }
        // SAFETY: no work is in flight (each piece is waited for), and no one else has the handles. Freeing unmaps;
        // null handles are ignored.
        unsafe {
            self.device.raw.destroy_buffer(self.raw, None);
            self.device.raw.free_memory(self.memory, None);
        }
        self.device
            .allocated
            .lock()
            .unwrap_or_else(PoisonError::into_inner)[self.heap] -= self.size;
    }
}
