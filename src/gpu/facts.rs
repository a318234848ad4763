//! Properties of a device beyond its limits: memory, floats, features. No rendering depends on them.

use ash::vk;

use super::instance::Instance;

/// Properties of a device.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    pub heaps: Vec<Heap>,
    /// Bytes that the invocations of a workgroup may share.
    pub shared_memory: u32,
    /// The GLSL types `double` and `int64_t`; vkpt's kernels have neither.
    pub float64: bool,
    pub int64: bool,
    /// `None` for a device of Vulkan 1.1, which does not report them.
    pub float_controls: Option<FloatControls>,
}

/// One of a device's memories.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heap {
    pub bytes: u64,
    pub device_local: bool,
}

/// The guarantees that shaders may demand of 32-bit floats (VkPhysicalDeviceFloatControlsProperties). vkpt's demand none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloatControls {
    pub denormals_kept: bool,
    pub denormals_flushed: bool,
    pub signed_zero_inf_nan_kept: bool,
    pub rounding_to_nearest: bool,
    pub rounding_to_zero: bool,
}

impl Facts {
    pub(super) fn of(instance: &Instance, device: vk::PhysicalDevice) -> Self {
        // SAFETY: the handle comes from this instance.
        let (properties, features, memory) = unsafe {
            let raw = &instance.raw;
            (
                raw.get_physical_device_properties(device),
                raw.get_physical_device_features(device),
                raw.get_physical_device_memory_properties(device),
            )
        };
        let heap = |h: &vk::MemoryHeap| Heap {
            bytes: h.size,
            device_local: h.flags.contains(vk::MemoryHeapFlags::DEVICE_LOCAL),
        };
        Self {
            heaps: memory.memory_heaps_as_slice().iter().map(heap).collect(),
            shared_memory: properties.limits.max_compute_shared_memory_size,
            float64: features.shader_float64 == vk::TRUE,
            int64: features.shader_int64 == vk::TRUE,
            float_controls: (properties.api_version >= vk::API_VERSION_1_2)
                .then(|| float_controls(instance, device)),
        }
    }
}

/// For a device of Vulkan 1.2.
fn float_controls(instance: &Instance, device: vk::PhysicalDevice) -> FloatControls {
    let mut controls = vk::PhysicalDeviceFloatControlsProperties::default();
    let mut all = vk::PhysicalDeviceProperties2::default().push_next(&mut controls);
    // SAFETY: the handle comes from this instance; a device of Vulkan 1.2 knows the chained struct.
    unsafe {
        instance
            .raw
            .get_physical_device_properties2(device, &mut all)
    };
    FloatControls {
        denormals_kept: controls.shader_denorm_preserve_float32 == vk::TRUE,
        denormals_flushed: controls.shader_denorm_flush_to_zero_float32 == vk::TRUE,
        signed_zero_inf_nan_kept: controls.shader_signed_zero_inf_nan_preserve_float32 == vk::TRUE,
        rounding_to_nearest: controls.shader_rounding_mode_rte_float32 == vk::TRUE,
        rounding_to_zero: controls.shader_rounding_mode_rtz_float32 == vk::TRUE,
    }
}
