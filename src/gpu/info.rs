//! Which devices there are, and which one is meant.

use std::ffi::CStr;
use std::fmt;

use ash::vk;

use super::error::GpuError;
use super::instance::Instance;

/// A Vulkan device, as `vkpt devices` lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceInfo {
    /// In the loader's order; what [`Selector::Index`] takes.
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

/// Which device to open.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Selector {
    /// The first usable one of the best kind: discrete, integrated, virtual, CPU.
    #[default]
    Best,
    Index(usize),
    /// The first whose name holds this, in any case of letters; a usable one before others.
    Name(String),
}

impl From<&str> for Selector {
    /// A number is an index, anything else part of a name.
    fn from(text: &str) -> Self {
        text.parse()
            .map_or_else(|_| Self::Name(text.to_owned()), Self::Index)
    }
}

impl Selector {
    /// Picks from `devices`.
    pub(super) fn pick<'a>(&self, devices: &'a [DeviceInfo]) -> Result<&'a DeviceInfo, GpuError> {
        let named = |d: &&DeviceInfo| match self {
            Self::Best => true,
            Self::Index(i) => d.index == *i,
            Self::Name(name) => d.name.to_lowercase().contains(&name.to_lowercase()),
        };
        let wanted = devices.iter().filter(named).min_by_key(|d| {
            let kind = if *self == Self::Best {
                d.kind
            } else {
                DeviceKind::Discrete
            };
            (d.unusable.is_some(), kind, d.index)
        });
        let device = wanted.ok_or_else(|| self.not_found(devices))?;
        match &device.unusable {
            None => Ok(device),
            Some(reason) => Err(GpuError::Unusable {
                name: device.name.clone(),
                reason: reason.clone(),
            }),
        }
    }

    fn not_found(&self, devices: &[DeviceInfo]) -> GpuError {
        let there: Vec<String> = devices
            .iter()
            .map(|d| format!("{} ({})", d.index, d.name))
            .collect();
        match self {
            Self::Best => GpuError::NoVulkan("the driver shows no device".into()),
            Self::Index(i) => GpuError::NoSuchDevice {
                wanted: i.to_string(),
                there: there.join(", "),
            },
            Self::Name(name) => GpuError::NoSuchDevice {
                wanted: format!("\"{name}\""),
                there: there.join(", "),
            },
        }
    }
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
/// [`GpuError::NoVulkan`] where there is no loader, no driver or no device.
pub fn devices() -> Result<Vec<DeviceInfo>, GpuError> {
    let instance = Instance::new(false)?;
    let all = enumerate(&instance)?;
    if all.is_empty() {
        return Err(GpuError::NoVulkan("the driver shows no device".into()));
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

/// A family of queues that compute, preferably the one that also draws: drivers treat it best.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn device(index: usize, name: &str, kind: DeviceKind, unusable: Option<&str>) -> DeviceInfo {
        DeviceInfo {
            index,
            name: name.into(),
            kind,
            driver: String::new(),
            vulkan: [1, 1, 0],
            memory: 0,
            unusable: unusable.map(String::from),
        }
    }

    fn pick(selector: &str) -> Result<usize, String> {
        let all = [
            device(0, "llvmpipe", DeviceKind::Cpu, None),
            device(
                1,
                "Old Card",
                DeviceKind::Discrete,
                Some("its driver offers Vulkan 1.0"),
            ),
            device(2, "Small Chip", DeviceKind::Integrated, None),
            device(3, "Large Card", DeviceKind::Discrete, None),
            device(4, "Other Card", DeviceKind::Discrete, None),
        ];
        let selector = if selector.is_empty() {
            Selector::Best
        } else {
            selector.into()
        };
        selector
            .pick(&all)
            .map(|d| d.index)
            .map_err(|e| e.to_string())
    }

    #[test]
    fn the_best_usable_device_is_picked() {
        assert_eq!(pick(""), Ok(3));
        assert_eq!(
            Selector::Best
                .pick(&[])
                .map(|d| d.index)
                .map_err(|e| matches!(e, GpuError::NoVulkan(_))),
            Err(true)
        );
    }

    #[test]
    fn devices_go_by_index_or_part_of_the_name() {
        assert_eq!(pick("2"), Ok(2));
        assert_eq!(pick("CARD"), Ok(3));
        assert_eq!(pick("llvm"), Ok(0));
    }

    #[test]
    fn an_unusable_or_absent_device_is_an_error_with_its_reason() {
        assert_eq!(
            pick("1"),
            Err("Old Card cannot be used: its driver offers Vulkan 1.0".into())
        );
        assert!(pick("9").is_err_and(|e| e.contains("3 (Large Card)")));
    }
}
