//! The list of devices.

use std::ffi::CStr;
use std::fmt;

use ash::vk;

use super::error::GpuError;
use super::instance::Instance;

/// A Vulkan device, as `vkpt devices` lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceInfo {
    /// In the loader's order; the index of [`Selector::Index`](super::Selector::Index).
    pub index: usize,
    pub name: String,
    pub kind: DeviceKind,
    /// The driver's name and version, such as "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)".
    pub driver: String,
    /// Vulkan's version: major, minor, patch.
    pub vulkan: [u32; 3],
    /// Bytes in its largest heap.
    pub memory: u64,
    /// Why it can't be used.
    pub unusable: Option<String>,
}

/// Best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DeviceKind {
    Discrete,
    Integrated,
    Virtual,
    Cpu,
    Other,
}

impl fmt::Display for DeviceKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Cpu => "cpu",
            Self::Other => "other",
        })
    }
}

/// All devices, in the loader's order.
///
/// # Errors
/// [`GpuError::NoVulkan`] if there is no loader, no driver or no device.
pub fn devices() -> Result<Vec<DeviceInfo>, GpuError> {
    let instance = Instance::new(false)?;
    let all = enumerate(&instance)?;
    if all.is_empty() {
        return Err(GpuError::NoVulkan("the driver reports no device".into()));
    }
    Ok(all.into_iter().map(|(_, info)| info).collect())
}

/// All devices with their handles.
pub(super) fn enumerate(
    instance: &Instance,
) -> Result<Vec<(vk::PhysicalDevice, DeviceInfo)>, GpuError> {
    // SAFETY: the instance is alive.
    let handles = unsafe { instance.raw.enumerate_physical_devices() }
        .map_err(GpuError::of("vkEnumeratePhysicalDevices"))?;
    Ok(handles
        .into_iter()
        .enumerate()
        .map(|(i, h)| (h, describe(instance, i, h)))
        .collect())
}

/// A queue family with compute, preferably the one with graphics too: drivers treat it best.
pub(super) fn compute_family(
    instance: &Instance,
    device: vk::PhysicalDevice,
) -> Option<(u32, vk::QueueFamilyProperties)> {
    // SAFETY: the handle comes from this instance.
    let families = unsafe {
        instance
            .raw
            .get_physical_device_queue_family_properties(device)
    };
    let computes = |f: &vk::QueueFamilyProperties| {
        f.queue_flags.contains(vk::QueueFlags::COMPUTE) && f.queue_count > 0
    };
    (0..)
        .zip(families)
        .filter(|(_, f)| computes(f))
        .max_by_key(|(i, f)| {
            (
                f.queue_flags.contains(vk::QueueFlags::GRAPHICS),
                std::cmp::Reverse(*i),
            )
        })
}

fn describe(instance: &Instance, index: usize, device: vk::PhysicalDevice) -> DeviceInfo {
    // SAFETY: the handle comes from this instance.
    let (properties, memory) = unsafe {
        let raw = &instance.raw;
        (
            raw.get_physical_device_properties(device),
            raw.get_physical_device_memory_properties(device),
        )
    };
    let version = properties.api_version;
    let vulkan = [
        vk::api_version_major(version),
        vk::api_version_minor(version),
        vk::api_version_patch(version),
    ];
    let unusable = if vulkan < [1, 1, 0] {
        Some("its driver offers Vulkan 1.0; vkpt needs 1.1".to_owned())
    } else if compute_family(instance, device).is_none() {
        Some("it has no compute queue".to_owned())
    } else {
        None
    };
    DeviceInfo {
        index,
        name: text(properties.device_name_as_c_str()),
        kind: kind(properties.device_type),
        driver: driver(instance, device, &properties),
        vulkan,
        memory: memory
            .memory_heaps_as_slice()
            .iter()
            .map(|h| h.size)
            .max()
            .unwrap_or(0),
        unusable,
    }
}

fn driver(
    instance: &Instance,
    device: vk::PhysicalDevice,
    properties: &vk::PhysicalDeviceProperties,
) -> String {
    if properties.api_version < vk::API_VERSION_1_2 {
        return format!("driver version {:#x}", properties.driver_version);
    }
    let mut driver = vk::PhysicalDeviceDriverProperties::default();
    let mut all = vk::PhysicalDeviceProperties2::default().push_next(&mut driver);
    // SAFETY: the handle comes from this instance; a device of Vulkan 1.2 knows the chained struct.
    unsafe {
        instance
            .raw
            .get_physical_device_properties2(device, &mut all)
    };
    let (name, info) = (
        text(driver.driver_name_as_c_str()),
        text(driver.driver_info_as_c_str()),
    );
    format!("{name} {info}").trim().to_owned()
}

fn kind(t: vk::PhysicalDeviceType) -> DeviceKind {
    match t {
        vk::PhysicalDeviceType::DISCRETE_GPU => DeviceKind::Discrete,
        vk::PhysicalDeviceType::INTEGRATED_GPU => DeviceKind::Integrated,
        vk::PhysicalDeviceType::VIRTUAL_GPU => DeviceKind::Virtual,
        vk::PhysicalDeviceType::CPU => DeviceKind::Cpu,
        _ => DeviceKind::Other,
    }
}

fn text<E>(name: Result<&CStr, E>) -> String {
    name.map_or_else(|_| String::new(), |n| n.to_string_lossy().into_owned())
}
