//! The limits of a device.

use ash::vk;

use super::instance::Instance;

/// The limits that vkpt respects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Bytes.
    pub storage_buffer: u64,
    /// Bytes.
    pub uniform_buffer: u64,
    /// Bytes in one allocation.
    pub allocation: u64,
    /// Storage buffers in one kernel.
    pub storage_buffers: u32,
    /// Uniform buffers in one kernel.
    pub uniform_buffers: u32,
    /// Bytes.
    pub push_constants: u32,
    /// Workgroups in a dispatch.
    pub group_count: [u32; 3],
    /// Invocations in a workgroup.
    pub group_size: [u32; 3],
    pub group_invocations: u32,
    /// Lanes that run together.
    pub subgroup: u32,
    /// Nanoseconds a tick.
    pub timestamp_period: f32,
}

impl Limits {
    pub(super) fn of(instance: &Instance, device: vk::PhysicalDevice) -> Self {
        let mut subgroup = vk::PhysicalDeviceSubgroupProperties::default();
        let mut maintenance = vk::PhysicalDeviceMaintenance3Properties::default();
        let mut all = vk::PhysicalDeviceProperties2::default()
            .push_next(&mut subgroup)
            .push_next(&mut maintenance);
        // SAFETY: the handle comes from this instance; both chained structs belong to Vulkan 1.1, which is required.
        unsafe {
            instance
                .raw
                .get_physical_device_properties2(device, &mut all)
        };
        let l = all.properties.limits;
        Self {
            storage_buffer: l.max_storage_buffer_range.into(),
            uniform_buffer: l.max_uniform_buffer_range.into(),
            allocation: maintenance.max_memory_allocation_size,
            storage_buffers: l.max_per_stage_descriptor_storage_buffers,
            uniform_buffers: l.max_per_stage_descriptor_uniform_buffers,
            push_constants: l.max_push_constants_size,
            group_count: l.max_compute_work_group_count,
            group_size: l.max_compute_work_group_size,
            group_invocations: l.max_compute_work_group_invocations,
            subgroup: subgroup.subgroup_size,
            timestamp_period: l.timestamp_period,
        }
    }
}
