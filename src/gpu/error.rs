//! Errors of a device, with advice for the user.

use std::time::Duration;

use ash::vk;

#[derive(Debug, Clone, thiserror::Error)]
pub enum GpuError {
    #[error(
        "no Vulkan device: {0}\n\
         Install a loader and a driver (Debian: apt install libvulkan1 mesa-vulkan-drivers; the latter brings lavapipe, \
         which needs no GPU), or render without Vulkan with --device cpu-f64."
    )]
    NoVulkan(String),
    #[error(
        "validation was requested, but VK_LAYER_KHRONOS_validation is not installed (Debian: vulkan-validationlayers)"
    )]
    NoValidationLayer,
    #[error("no device {wanted}; the devices are: {there}")]
    NoSuchDevice { wanted: String, there: String },
    #[error("{name} cannot be used: {reason}")]
    Unusable { name: String, reason: String },
    #[error("{name} needs {bytes} bytes, more than {limit} bytes, {what}")]
    TooLarge {
        name: String,
        bytes: u64,
        limit: u64,
        what: &'static str,
    },
    #[error("{name} has {bytes} bytes, but {given} were given")]
    WrongLength {
        name: String,
        bytes: u64,
        given: u64,
    },
    #[error("dispatch: {0}")]
    Mismatch(String),
    #[error("the device did not finish within {0:?}, and is treated as hung")]
    TimeOut(Duration),
    #[error(
        "the device was lost: its driver stopped the kernel (as watchdogs do after seconds) or crashed"
    )]
    Lost,
    #[error("out of memory on the device, at {0}")]
    OutOfMemory(String),
    #[error("Vulkan: {call}: {result}")]
    Vulkan {
        call: &'static str,
        result: vk::Result,
    },
    #[error(transparent)]
    Kernel(#[from] crate::kernel::KernelError),
}

/// The Vulkan calls that open a device.
const OPENING: [&str; 4] = [
    "vkCreateInstance",
    "vkCreateDebugUtilsMessengerEXT",
    "vkEnumeratePhysicalDevices",
    "vkCreateDevice",
];

impl GpuError {
    /// Whether the device failed during work, and the same work may succeed on the device opened again: not if it could
    /// not be opened, or cannot do what was requested.
    pub fn is_loss(&self) -> bool {
        match self {
            Self::TimeOut(_) | Self::Lost | Self::OutOfMemory(_) => true,
            Self::Vulkan { call, .. } => !OPENING.contains(call),
            Self::NoVulkan(_)
            | Self::NoValidationLayer
            | Self::NoSuchDevice { .. }
            | Self::Unusable { .. }
            | Self::TooLarge { .. }
            | Self::WrongLength { .. }
            | Self::Mismatch(_)
            | Self::Kernel(_) => false,
        }
    }

    /// For `map_err`: the error of one Vulkan call.
    pub(super) fn of(call: &'static str) -> impl Fn(vk::Result) -> Self {
        move |result| match result {
            vk::Result::ERROR_DEVICE_LOST => Self::Lost,
            vk::Result::ERROR_OUT_OF_DEVICE_MEMORY | vk::Result::ERROR_OUT_OF_HOST_MEMORY => {
                Self::OutOfMemory(call.to_owned())
            }
            result => Self::Vulkan { call, result },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn losses_are_errors_that_another_device_may_avoid() {
        let of = |call, result| GpuError::of(call)(result);
        for error in [
            GpuError::TimeOut(Duration::from_secs(1)),
            of("vkQueueSubmit", vk::Result::ERROR_DEVICE_LOST),
            of("vkAllocateMemory", vk::Result::ERROR_OUT_OF_HOST_MEMORY),
            of("vkWaitForFences", vk::Result::ERROR_UNKNOWN),
            of("vkMapMemory", vk::Result::ERROR_INITIALIZATION_FAILED),
        ] {
            assert!(error.is_loss(), "{error}");
        }
        for error in [
            GpuError::NoVulkan("no driver".into()),
            of("vkCreateDevice", vk::Result::ERROR_INITIALIZATION_FAILED),
            GpuError::Mismatch("two buffers".into()),
        ] {
            assert!(!error.is_loss(), "{error}");
        }
    }
}
