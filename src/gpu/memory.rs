//! The memory of a buffer: its kind, the amount left, and whether the host sees it.

use std::ptr::NonNull;
use std::sync::PoisonError;

use ash::vk;

use super::buffer::Buffer;
use super::error::GpuError;
use super::info::DeviceKind;
use super::shared_device::SharedDevice;

/// Whether the host reaches a kernel's buffers only by copies: across a bus it reads device memory
/// slowly, even if it sees it.
pub(super) fn stages(device: &SharedDevice) -> bool {
    matches!(device.info.kind, DeviceKind::Discrete | DeviceKind::Virtual)
        || device.options.always_stage
}

/// Kinds of memory for a kernel's buffers, best first.
pub(super) fn kinds_of_memory(device: &SharedDevice) -> Vec<vk::MemoryPropertyFlags> {
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
    /// Allocates, binds and, if requested and possible, maps.
    pub(super) fn allocate(
        &mut self,
        kinds: &[vk::MemoryPropertyFlags],
        map: bool,
    ) -> Result<(), GpuError> {
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
            GpuError::OutOfMemory(format!("{}: no suitable memory type", self.name))
        })?;
        self.reserve(types[index].heap_index as usize, needs.size)?;
        let info = vk::MemoryAllocateInfo::default()
            .allocation_size(needs.size)
            .memory_type_index(index as u32);
        // SAFETY: index and size are what the device asked for; the memory is bound once and mapped once.
        unsafe {
            let allocated = device.raw.allocate_memory(&info, None);
            self.memory =
                allocated.map_err(|result| match GpuError::of("vkAllocateMemory")(result) {
                    GpuError::OutOfMemory(_) => {
                        GpuError::OutOfMemory(format!("{} ({} bytes)", self.name, self.bytes))
                    }
                    other => other,
                })?;
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

    /// Reserves `size` bytes of a heap, or refuses.
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
            (left, "the device's free memory")
        } else {
            (
                self.device.limits.allocation,
                "the device's limit for an allocation",
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
}
