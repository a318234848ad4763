//! An opened device.

use std::sync::Arc;

use super::error::GpuError;
use super::facts::Facts;
use super::info::DeviceInfo;
use super::limits::Limits;
use super::options::Options;
use super::selector::Selector;
use super::shared_device::SharedDevice;

/// A Vulkan device with one compute queue. Clones share it.
#[derive(Clone)]
pub struct Device(pub(super) Arc<SharedDevice>);

impl Device {
    /// Opens a device with [`Options::from_env`].
    ///
    /// # Errors
    /// [`GpuError::NoVulkan`], [`GpuError::NoSuchDevice`], [`GpuError::Unusable`], [`GpuError::NoValidationLayer`], or
    /// Vulkan's own.
    pub fn open(selector: &Selector) -> Result<Self, GpuError> {
        Self::open_with(selector, Options::from_env())
    }

    /// Opens a device. Errors: see [`open`](Self::open).
    pub fn open_with(selector: &Selector, options: Options) -> Result<Self, GpuError> {
        Ok(Self(Arc::new(SharedDevice::open(selector, options)?)))
    }

    pub fn info(&self) -> &DeviceInfo {
        &self.0.info
    }

    pub fn limits(&self) -> &Limits {
        &self.0.limits
    }

    /// Its further properties.
    pub fn facts(&self) -> &Facts {
        &self.0.facts
    }

    /// Whether the validation layer is active.
    pub fn is_validated(&self) -> bool {
        self.0.options.validation
    }

    /// Warnings and errors of the validation layer so far; empty if validation is off.
    pub fn validation_messages(&self) -> Vec<String> {
        self.0.validation_messages()
    }
}
