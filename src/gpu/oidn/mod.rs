//! Intel's Open Image Denoise, a neural network that denoises pictures, from a library that is found at run time. Its C API:
//! <https://www.openimagedenoise.org/documentation.html>.
//!
//! It runs on the CPU alone, with the same bits for any number of threads.

mod api;
mod filter;

use std::ffi::{CStr, OsStr, c_char, c_int};
use std::ptr::{NonNull, null};

use api::{Api, Device};
pub use filter::Pixels;
use filter::{Filter, Input};

/// Errors of the denoiser.
#[derive(Clone, Debug, thiserror::Error)]
pub enum OidnError {
    #[error("{0}")]
    NoLibrary(String),
    #[error("it has no {0}: Open Image Denoise 2 or later is needed")]
    TooOld(String),
    #[error("it has no device for this CPU{0}")]
    NoDevice(String),
    #[error("Open Image Denoise: {0}")]
    Failed(String),
}

/// The library and its device.
pub struct Oidn {
    // Freed before the library is unloaded.
    device: OwnDevice,
    version: c_int,
}

/// A device that frees itself.
struct OwnDevice {
    api: Api,
    device: NonNull<Device>,
}

const CPU: c_int = 1;

impl Oidn {
    /// Loads the library of this name or path, by the rules of the system's loader, and opens its device.
    ///
    /// # Errors
    /// If it does not exist, or is another library.
    pub fn load(library: &OsStr) -> Result<Self, OidnError> {
        let api = Api::load(library)?;
        // SAFETY: the function has this signature since version 2, which `Api::load` has made sure of.
        let device = unsafe { (api.new_device)(CPU) };
        let Some(device) = NonNull::new(device) else {
            let reason = failure(&api, null::<Device>().cast_mut());
            let reason = reason.map_or(String::new(), |why| format!(": {why}"));
            return Err(OidnError::NoDevice(reason));
        };
        let device = OwnDevice { api, device };
        // SAFETY: the device is alive.
        let version = unsafe {
            (device.api.commit_device)(device.raw());
            (device.api.get_device_int)(device.raw(), c"version".as_ptr())
        };
        device.check()?;
        Ok(Self { device, version })
    }

    /// For example 2.5.1.
    pub fn version(&self) -> String {
        let [major, minor, patch] = [10_000, 100, 1].map(|unit| self.version / unit % 100);
        format!("{major}.{minor}.{patch}")
    }

    /// Denoises linear radiance. `albedo` and `normal`, if given, are those of the surfaces seen; their own noise is
    /// removed first.
    ///
    /// # Errors
    /// Those of the library.
    pub fn denoise(
        &self,
        colour: &Pixels,
        guides: Option<[&Pixels; 2]>,
    ) -> Result<Pixels, OidnError> {
        let Some([albedo, normal]) = guides else {
            return self.run(&[(Input::Colour, colour)]);
        };
        let albedo = self.run(&[(Input::Albedo, albedo)])?;
        let normal = self.run(&[(Input::Normal, normal)])?;
        self.run(&[
            (Input::Colour, colour),
            (Input::Albedo, &albedo),
            (Input::Normal, &normal),
        ])
    }

    /// Filters the first of the inputs, with the help of the others.
    fn run(&self, inputs: &[(Input, &Pixels)]) -> Result<Pixels, OidnError> {
        Filter::new(&self.device)?.run(inputs)
    }
}

impl OwnDevice {
    fn raw(&self) -> *mut Device {
        self.device.as_ptr()
    }

    /// The error since the last check, if any.
    fn check(&self) -> Result<(), OidnError> {
        match failure(&self.api, self.raw()) {
            None => Ok(()),
            Some(why) => Err(OidnError::Failed(why)),
        }
    }
}

impl Drop for OwnDevice {
    fn drop(&mut self) {
        // SAFETY: the device is alive, and no one else has it.
        unsafe { (self.api.release_device)(self.raw()) }
    }
}

/// The message of the first error of a device, or of this thread if `device` is null.
fn failure(api: &Api, device: *mut Device) -> Option<String> {
    let mut message: *const c_char = null();
    // SAFETY: a device is alive, null is allowed; the message lives until the next call, which comes after it was copied.
    unsafe {
        match (api.get_device_error)(device, &mut message) {
            0 => None,
            _ if message.is_null() => Some("an error without a message".to_owned()),
            _ => Some(CStr::from_ptr(message).to_string_lossy().into_owned()),
        }
    }
}
