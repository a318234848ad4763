//! Buffers, each with memory of its own.

use std::ptr::NonNull;
use std::sync::{Arc, PoisonError};

use ash::vk;

use super::device::{Device, Inner};
use super::error::GpuError;
use super::info::DeviceKind;

/// How a kernel sees a buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BufferUse {
    /// Small, read only, std140: `layout(std140) uniform`.
    Uniform,
    /// Read and written, std430: `layout(std430) buffer`.
    Storage,
}

/// Device memory with a name, zeros at first.
pub struct Buffer {
    pub(super) device: Arc<Inner>,
    pub(super) name: String,
    pub(super) usage: BufferUse,
    pub(super) bytes: u64,
    pub(super) raw: vk::Buffer,
    memory: vk::DeviceMemory,
    heap: usize,
    /// What was taken from the heap.
    size: u64,
    /// The first byte, where the host sees it.
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
    /// [`GpuError::TooLarge`], before anything is allocated, where `bytes` is more than the device allows for this
    /// use or than its memory has left.
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
                "what the device allows in one uniform buffer",
            ),
            BufferUse::Storage => (
                self.0.limits.storage_buffer,
                "what the device allows in one storage buffer",
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

/// Whether the host reaches a kernel's buffers by copies only: across a bus it reads device memory slowly, even
/// where it sees it.
fn stages(device: &Inner) -> bool {
    matches!(device.info.kind, DeviceKind::Discrete | DeviceKind::Virtual)
        || device.options.always_stage
}

/// Kinds of memory for a kernel's buffers, best first.
fn kinds_of_memory(device: &Inner) -> Vec<vk::MemoryPropertyFlags> {
    use vk::MemoryPropertyFlags as M;
    if stages(device) {
        return vec![M::DEVICE_LOCAL, M::empty()];
    }
    let visible = M::HOST_VISIBLE | M::HOST_COHERENT;
    vec![
        visible | M::DEVICE_LOCAL | M::HOST_CACHED,
        visible | M::DEVICE_LOCAL,
        M::DEVICE_LOCAL,
        M::empty(),
    ]
}

impl Buffer {
    /// Without zeros. A buffer of 0 bytes is legal here, so it takes at least 16.
    pub(super) fn new(
        device: &Arc<Inner>,
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

    fn allocate(&mut self, kinds: &[vk::MemoryPropertyFlags], map: bool) -> Result<(), GpuError> {
        let device = self.device.clone();
        // SAFETY: the buffer is alive.
        let needs = unsafe { device.raw.get_buffer_memory_requirements(self.raw) };
        let types = device.memory.memory_types_as_slice();
        let fits = |i: usize, kind| {
            needs.memory_type_bits >> i & 1 == 1 && types[i].property_flags.contains(kind)
        };
        let index = kinds
            .iter()
            .find_map(|kind| (0..types.len()).find(|i| fits(*i, *kind)));
        let index = index.ok_or_else(|| {
            GpuError::OutOfMemory(format!("{}: no kind of memory fits", self.name))
        })?;
        self.reserve(types[index].heap_index as usize, needs.size)?;
        let info = vk::MemoryAllocateInfo::default()
            .allocation_size(needs.size)
            .memory_type_index(index as u32);
        // SAFETY: index and size are what the device asked for; the memory is bound once and mapped once.
        unsafe {
            let out = |_| GpuError::OutOfMemory(format!("{} ({} bytes)", self.name, self.bytes));
            self.memory = device.raw.allocate_memory(&info, None).map_err(out)?;
            device
                .raw
                .bind_buffer_memory(self.raw, self.memory, 0)
                .map_err(GpuError::of("vkBindBufferMemory"))?;
            let visible =
                vk::MemoryPropertyFlags::HOST_VISIBLE | vk::MemoryPropertyFlags::HOST_COHERENT;
            if types[index].property_flags.contains(visible) && map {
                let first =
                    device
                        .raw
                        .map_memory(self.memory, 0, vk::WHOLE_SIZE, Default::default());
                self.mapped = NonNull::new(first.map_err(GpuError::of("vkMapMemory"))?.cast());
            }
        }
        Ok(())
    }

    /// Enters `size` bytes in the books, or refuses.
    fn reserve(&mut self, heap: usize, size: u64) -> Result<(), GpuError> {
        let mut allocated = self
            .device
            .allocated
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let left = self.device.memory.memory_heaps[heap]
            .size
            .saturating_sub(allocated[heap]);
        let (limit, what) = if left < self.device.limits.allocation {
            (left, "what is left of the device's memory")
        } else {
            (
                self.device.limits.allocation,
                "what the device allows in one allocation",
            )
        };
        if size > limit {
            return Err(GpuError::TooLarge {
                name: self.name.clone(),
                bytes: self.bytes,
                limit,
                what,
            });
        }
        allocated[heap] += size;
        (self.heap, self.size) = (heap, size);
        Ok(())
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// Size as asked for.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        if self.device.is_abandoned() {
            return;
        }
        // SAFETY: no work is under way (each piece is waited for), and nobody else has the handles.
        // Freeing unmaps; null handles are ignored.
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
