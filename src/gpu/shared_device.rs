//! The handles and properties that everything on a device shares.

use std::mem::ManuallyDrop;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use ash::{khr, vk};

use super::error::GpuError;
use super::facts::Facts;
use super::info::{DeviceInfo, compute_family, enumerate};
use super::instance::Instance;
use super::limits::Limits;
use super::options::Options;
use super::pipeline_cache::Owner;
use super::queue::Queue;
use super::selector::Selector;
use super::statistics;

/// An opened device, which its clones, buffers and pipelines keep alive.
pub(super) struct SharedDevice {
    pub raw: ash::Device,
    pub info: DeviceInfo,
    pub limits: Limits,
    pub facts: Facts,
    pub memory: vk::PhysicalDeviceMemoryProperties,
    /// Bytes that this device has allocated from each heap.
    pub allocated: Mutex<[u64; vk::MAX_MEMORY_HEAPS]>,
    pub options: Options,
    /// The owner of the compiled kernels in the cache on disk.
    pub cache_owner: Owner,
    /// If statistics were requested and the device has them.
    pub statistics: Option<khr::pipeline_executable_properties::Device>,
    pub loop_limit: OnceLock<Option<u32>>,
    queue: Mutex<Queue>,
    /// Set after a time-out, or if waiting failed: the device may still be writing, so nothing it uses may be freed.
    abandoned: AtomicBool,
    /// Set once Vulkan reports the loss: the device does nothing any more, so its objects may be freed, and must be.
    lost: AtomicBool,
    /// Dropped last, and not at all after a time-out: an instance must not go before its device.
    instance: ManuallyDrop<Instance>,
}

impl SharedDevice {
    /// Opens the device, with one compute queue.
    pub fn open(selector: &Selector, options: Options) -> Result<Self, GpuError> {
        let instance = Instance::new(options.validation)?;
        let all = enumerate(&instance)?;
        let infos: Vec<DeviceInfo> = all.iter().map(|(_, info)| info.clone()).collect();
        let info = selector.pick(&infos)?.clone();
        let physical = all[info.index].0;
        let no_queue = || GpuError::Unusable {
            name: info.name.clone(),
            reason: "it has no compute queue".into(),
        };
        let (family, properties) = compute_family(&instance, physical).ok_or_else(no_queue)?;
        let counts = options.statistics && statistics::are_offered(&instance, physical);
        let raw = create(&instance, physical, family, counts)?;
        let queue = match Queue::new(&raw, family, properties.timestamp_valid_bits) {
            Ok(queue) => queue,
            Err(error) => {
                // SAFETY: the device has no work and no children: `Queue::new` has cleaned up after itself.
                unsafe { raw.destroy_device(None) };
                return Err(error);
            }
        };
        Ok(Self {
            limits: Limits::of(&instance, physical),
            facts: Facts::of(&instance, physical),
            // SAFETY: the handle comes from this instance.
            memory: unsafe { instance.raw.get_physical_device_memory_properties(physical) },
            allocated: Mutex::new([0; vk::MAX_MEMORY_HEAPS]),
            cache_owner: Owner::of(&instance, physical, &info),
            statistics: counts
                .then(|| khr::pipeline_executable_properties::Device::new(&instance.raw, &raw)),
            loop_limit: OnceLock::new(),
            abandoned: AtomicBool::new(false),
            lost: AtomicBool::new(false),
            queue: Mutex::new(queue),
            raw,
            info,
            options,
            instance: ManuallyDrop::new(instance),
        })
    }

    /// The queue, for as long as the guard lives. Host access to mapped memory also holds it, so that host and device
    /// never touch a buffer at once.
    pub fn queue(&self) -> Result<MutexGuard<'_, Queue>, GpuError> {
        let guard = self.queue.lock().unwrap_or_else(PoisonError::into_inner);
        if self.is_abandoned() || self.lost.load(Ordering::Acquire) {
            Err(GpuError::Lost)
        } else {
            Ok(guard)
        }
    }

    /// Warnings and errors of the validation layer so far.
    pub fn validation_messages(&self) -> Vec<String> {
        self.instance.messages()
    }

    pub fn is_abandoned(&self) -> bool {
        self.abandoned.load(Ordering::Acquire)
    }

    /// Gives up a device that failed during work.
    pub fn give_up(&self, error: &GpuError) {
        match error {
            GpuError::Lost => self.lost.store(true, Ordering::Release),
            _ => self.abandoned.store(true, Ordering::Release),
        }
    }
}

fn create(
    instance: &Instance,
    physical: vk::PhysicalDevice,
    family: u32,
    counts: bool,
) -> Result<ash::Device, GpuError> {
    let queues = [vk::DeviceQueueCreateInfo::default()
        .queue_family_index(family)
        .queue_priorities(&[1.0])];
    let extensions = [khr::pipeline_executable_properties::NAME.as_ptr()];
    let mut feature = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default()
        .pipeline_executable_info(true);
    let mut info = vk::DeviceCreateInfo::default().queue_create_infos(&queues);
    if counts {
        info = info
            .enabled_extension_names(&extensions)
            .push_next(&mut feature);
    }
    // SAFETY: the handle comes from this instance, the family from the device; `counts` only where it is offered.
    unsafe { instance.raw.create_device(physical, &info, None) }
        .map_err(GpuError::of("vkCreateDevice"))
}

impl Drop for SharedDevice {
    fn drop(&mut self) {
        if self.is_abandoned() {
            return;
        }
        let queue = self.queue.get_mut().unwrap_or_else(PoisonError::into_inner);
        // SAFETY: buffers and pipelines hold an `Arc` of this, so none is left; every piece of work was waited for, or
        // ended with the device.
        // The instance is not touched again.
        unsafe {
            queue.destroy(&self.raw);
            self.raw.destroy_device(None);
            ManuallyDrop::drop(&mut self.instance);
        }
    }
}
