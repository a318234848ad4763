//! A driver's statistics of its compiled kernels (VK_KHR_pipeline_executable_properties).

use std::ffi::{CStr, c_char};
use std::fmt;

use ash::{khr, vk};

use super::device::Device;
use super::error::GpuError;
use super::instance::Instance;
use super::pipeline::Pipeline;

/// One number of a compiled kernel. Names, meanings and units are the driver's own.
#[derive(Clone, Debug, PartialEq)]
pub struct Statistic {
    /// The machine code that it describes: drivers may compile a kernel several times, for subgroups of several sizes.
    pub executable: String,
    /// For example "Instructions", "VGPRs" or "Code size".
    pub name: String,
    pub value: Value,
    pub description: String,
}

/// A statistic's value, in one of the types that drivers choose from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Bool(bool),
    Signed(i64),
    Unsigned(u64),
    Float(f64),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(value) => value.fmt(f),
            Self::Signed(value) => value.fmt(f),
            Self::Unsigned(value) => value.fmt(f),
            Self::Float(value) => value.fmt(f),
        }
    }
}

/// Whether the device has statistics at all.
pub(super) fn are_offered(instance: &Instance, device: vk::PhysicalDevice) -> bool {
    // SAFETY: the handle comes from this instance.
    let extensions = unsafe { instance.raw.enumerate_device_extension_properties(device) };
    let is_it = |e: &vk::ExtensionProperties| {
        e.extension_name_as_c_str() == Ok(khr::pipeline_executable_properties::NAME)
    };
    if !extensions.unwrap_or_default().iter().any(is_it) {
        return false;
    }
    let mut feature = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default();
    let mut all = vk::PhysicalDeviceFeatures2::default().push_next(&mut feature);
    // SAFETY: the handle comes from this instance; the device has the extension of the chained struct.
    unsafe { instance.raw.get_physical_device_features2(device, &mut all) };
    feature.pipeline_executable_info == vk::TRUE
}

impl Device {
    /// Whether its driver has statistics, and collects them.
    pub fn counts(&self) -> bool {
        self.0.statistics.is_some()
    }
}

impl Pipeline {
    /// The driver's statistics of the kernel. Empty if the device does not report any, or was opened without
    /// [`Options::statistics`](super::Options::statistics).
    ///
    /// # Errors
    /// Vulkan's own.
    pub fn statistics(&self) -> Result<Vec<Statistic>, GpuError> {
        let Some(functions) = &self.device.statistics else {
            return Ok(Vec::new());
        };
        let info = vk::PipelineInfoKHR::default().pipeline(self.raw);
        // SAFETY: the device has the extension and its feature enabled, and made the pipeline.
        let executables = unsafe { functions.get_pipeline_executable_properties(&info) }
            .map_err(GpuError::of("vkGetPipelineExecutablePropertiesKHR"))?;
        let mut all = Vec::new();
        for (i, executable) in (0..).zip(&executables) {
            let info = vk::PipelineExecutableInfoKHR::default()
                .pipeline(self.raw)
                .executable_index(i);
            // SAFETY: as above; the pipeline was made with CAPTURE_STATISTICS, and has an executable `i`.
            let counted = unsafe { functions.get_pipeline_executable_statistics(&info) }
                .map_err(GpuError::of("vkGetPipelineExecutableStatisticsKHR"))?;
            let name = text(&executable.name);
            all.extend(counted.iter().map(|s| statistic(&name, s)));
        }
        Ok(all)
    }
}

fn statistic(executable: &str, s: &vk::PipelineExecutableStatisticKHR) -> Statistic {
    use vk::PipelineExecutableStatisticFormatKHR as Format;
    // SAFETY: the format says which member the driver has written; any 64 bits are a number, and `b32` is one too.
    let value = unsafe {
        match s.format {
            Format::BOOL32 => Value::Bool(s.value.b32 != vk::FALSE),
            Format::INT64 => Value::Signed(s.value.i64),
            Format::FLOAT64 => Value::Float(s.value.f64),
            _ => Value::Unsigned(s.value.u64),
        }
    };
    Statistic {
        executable: executable.to_owned(),
        name: text(&s.name),
        value,
        description: text(&s.description),
    }
}

/// Up to the first 0; empty if a driver forgot it.
fn text(bytes: &[c_char]) -> String {
    let bytes = bytemuck::cast_slice(bytes);
    CStr::from_bytes_until_nul(bytes)
        .map_or_else(|_| String::new(), |s| s.to_string_lossy().into_owned())
}
