//! A driver's compiled kernels, kept on disk from one process to the next (Vulkan 1.3, section 10.7, "Pipeline Cache").
//!
//! One file for each kernel on each device with each version of its driver. A driver must accept only its own data, so
//! bytes reach it only if the file is whole and their header names this device and driver. Without a cache, or with one
//! that fails in any way, pipelines are the same and only take longer.

use std::path::Path;

use ash::vk;

use super::info::DeviceInfo;
use super::instance::Instance;
use super::shared_device::SharedDevice;
use crate::cache::{CacheFolder, Room, hash};
use crate::kernel::Spirv;

/// Bytes of [`header`].
const HEADER: usize = 16 + vk::UUID_SIZE;

/// The kernels of all devices.
const ROOM: Room = Room {
    files: 64,
    bytes: 64 << 20,
};

/// The device and driver that the data belong to.
pub(super) struct Owner {
    /// The required beginning of the driver's data.
    header: [u8; HEADER],
    /// Everything known of device and driver; some drivers do not put their version into the header's UUID.
    name: String,
}

impl Owner {
    pub fn of(instance: &Instance, device: vk::PhysicalDevice, info: &DeviceInfo) -> Self {
        // SAFETY: the handle comes from this instance.
        let properties = unsafe { instance.raw.get_physical_device_properties(device) };
        Self::new(info, &properties)
    }

    fn new(info: &DeviceInfo, properties: &vk::PhysicalDeviceProperties) -> Self {
        let header = header(properties);
        let (device, driver, version) = (&info.name, &info.driver, properties.driver_version);
        let name = format!("{device}\n{driver}\n{version:#x}\n{header:x?}");
        Self { header, name }
    }

    fn owns(&self, data: &[u8]) -> bool {
        data.starts_with(&self.header)
    }
}

/// `VkPipelineCacheHeaderVersionOne`, least significant bytes first: its own size, version, vendor, device, UUID.
fn header(properties: &vk::PhysicalDeviceProperties) -> [u8; HEADER] {
    let version = vk::PipelineCacheHeaderVersion::ONE.as_raw() as u32;
    let numbers = [
        HEADER as u32,
        version,
        properties.vendor_id,
        properties.device_id,
    ];
    let mut header = [0; HEADER];
    header[..16].copy_from_slice(numbers.map(u32::to_le_bytes).as_flattened());
    header[16..].copy_from_slice(&properties.pipeline_cache_uuid);
    header
}

/// The driver's cache for one kernel, while its pipeline is made.
pub(super) struct PipelineCache<'a> {
    device: &'a SharedDevice,
    kept: Option<Kept<'a>>,
}

struct Kept<'a> {
    raw: vk::PipelineCache,
    folder: CacheFolder<'a>,
    key: String,
    /// Bytes of the driver's data initially.
    bytes: usize,
}

impl<'a> PipelineCache<'a> {
    /// With the data that earlier processes left for this kernel, on this device with this driver.
    pub fn open(device: &'a SharedDevice, kernel: &Spirv) -> Self {
        let folder = device.options.cache.as_deref();
        let kept = folder.and_then(|folder| Kept::open(device, folder, kernel));
        Self { device, kept }
    }

    /// For the driver; null if nothing is kept.
    pub fn raw(&self) -> vk::PipelineCache {
        self.kept
            .as_ref()
            .map_or(vk::PipelineCache::null(), |kept| kept.raw)
    }

    /// Stores the driver's additions for later processes. Many drivers add nothing: Mesa's lavapipe compiles later and
    /// has its own cache.
    pub fn keep(&self) {
        let Some(kept) = &self.kept else { return };
        let data = data(self.device, kept.raw);
        if data.len() > kept.bytes && self.device.cache_owner.owns(&data) {
            // A cache that can't be written is no reason to fail: later processes compile again.
            let _ = kept.folder.write(&kept.key, &data);
        }
    }
}

impl<'a> Kept<'a> {
    fn open(device: &SharedDevice, folder: &'a Path, kernel: &Spirv) -> Option<Self> {
        let owner = &device.cache_owner;
        let (folder, key) = (
            CacheFolder::new(folder, ROOM),
            format!("{}\nkernel {:016x}", owner.name, hash(kernel.bytes())),
        );
        let found = folder.read(&key).filter(|data| owner.owns(data));
        let raw = found.and_then(|data| create(device, &data));
        let raw = raw.or_else(|| create(device, &[]))?;
        let bytes = data(device, raw).len();
        Some(Self {
            raw,
            folder,
            key,
            bytes,
        })
    }
}

impl Drop for PipelineCache<'_> {
    fn drop(&mut self) {
        // SAFETY: the pipeline is made, and no one else has the handle; null is ignored.
        unsafe { self.device.raw.destroy_pipeline_cache(self.raw(), None) };
    }
}

/// `None` if the driver fails, which it may for any data.
fn create(device: &SharedDevice, data: &[u8]) -> Option<vk::PipelineCache> {
    let info = vk::PipelineCacheCreateInfo::default().initial_data(data);
    // SAFETY: the info is complete; data begin with this driver's header and are, to the checksum, what it gave.
    unsafe { device.raw.create_pipeline_cache(&info, None) }.ok()
}

/// All that the driver has stored; empty if it fails.
fn data(device: &SharedDevice, cache: vk::PipelineCache) -> Vec<u8> {
    // SAFETY: the cache was made by this device and is alive.
    unsafe { device.raw.get_pipeline_cache_data(cache) }.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::DeviceKind;

    const UUID: [u8; 16] = *b"a driver's build";

    fn properties() -> vk::PhysicalDeviceProperties {
        vk::PhysicalDeviceProperties {
            vendor_id: 0x10de,
            device_id: 0x01_02_03_04,
            driver_version: 7,
            pipeline_cache_uuid: UUID,
            ..Default::default()
        }
    }

    fn owner(driver: &str, properties: &vk::PhysicalDeviceProperties) -> Owner {
        let info = DeviceInfo {
            index: 0,
            name: "a card".into(),
            kind: DeviceKind::Discrete,
            driver: driver.into(),
            vulkan: [1, 1, 0],
            memory: 0,
            unusable: None,
        };
        Owner::new(&info, properties)
    }

    /// Vulkan 1.3, table "Layout for pipeline cache header version VK_PIPELINE_CACHE_HEADER_VERSION_ONE".
    #[test]
    fn data_begin_with_the_header_that_vulkan_prescribes() {
        let numbers = [32, 0, 0, 0, 1, 0, 0, 0, 0xde, 0x10, 0, 0, 4, 3, 2, 1];
        let data = [&numbers[..], &UUID, b"what the driver adds"].concat();
        let owner = owner("driver", &properties());
        assert!(owner.owns(&data) && owner.owns(&data[..32]));
        for length in 0..32 {
            assert!(!owner.owns(&data[..length]), "{length} bytes");
        }
        for bit in 0..8 * 32 {
            let mut foreign = data.clone();
            foreign[bit / 8] ^= 1 << (bit % 8);
            assert!(!owner.owns(&foreign), "bit {bit}");
        }
    }

    #[test]
    fn every_part_of_device_and_driver_is_in_the_name() {
        let p = properties();
        let same = owner("driver", &p).name;
        let mut uuid = UUID;
        uuid[15] ^= 1;
        let mut others: Vec<_> = [
            vk::PhysicalDeviceProperties { vendor_id: 1, ..p },
            vk::PhysicalDeviceProperties { device_id: 1, ..p },
            vk::PhysicalDeviceProperties {
                driver_version: 8,
                ..p
            },
            vk::PhysicalDeviceProperties {
                pipeline_cache_uuid: uuid,
                ..p
            },
        ]
        .map(|p| owner("driver", &p).name)
        .into();
        others.push(owner("driver 2", &p).name);
        assert!(others.iter().all(|name| *name != same));
    }
}
