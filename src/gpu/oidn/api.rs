//! The functions of the library that vkpt calls.

use std::ffi::{OsStr, c_char, c_int, c_void};

use libloading::Library;

use super::OidnError;

/// Opaque.
pub enum Device {}
/// Opaque.
pub enum RawFilter {}

/// Functions, by their names in the header without `oidn`.
pub struct Api {
    pub new_device: unsafe extern "C" fn(c_int) -> *mut Device,
    pub commit_device: unsafe extern "C" fn(*mut Device),
    pub release_device: unsafe extern "C" fn(*mut Device),
    pub get_device_int: unsafe extern "C" fn(*mut Device, *const c_char) -> c_int,
    pub get_device_error: unsafe extern "C" fn(*mut Device, *mut *const c_char) -> c_int,
    pub new_filter: unsafe extern "C" fn(*mut Device, *const c_char) -> *mut RawFilter,
    pub release_filter: unsafe extern "C" fn(*mut RawFilter),
    pub set_filter_bool: unsafe extern "C" fn(*mut RawFilter, *const c_char, bool),
    pub set_image: SetImage,
    pub commit_filter: unsafe extern "C" fn(*mut RawFilter),
    pub execute_filter: unsafe extern "C" fn(*mut RawFilter),
    /// Keeps the functions loaded.
    _library: Library,
}

/// Filter, name, pixels, format, width, height, byte offset, bytes from pixel to pixel and from row to row.
pub type SetImage = unsafe extern "C" fn(
    *mut RawFilter,
    *const c_char,
    *mut c_void,
    c_int,
    usize,
    usize,
    usize,
    usize,
    usize,
);

impl Api {
    /// # Errors
    /// If the library cannot be loaded, or lacks a function.
    pub fn load(library: &OsStr) -> Result<Self, OidnError> {
        // SAFETY: code that runs when a library is loaded is its own responsibility; it is Intel's, or the one that the
        // user has named.
        let library = unsafe { Library::new(library) };
        let library = library.map_err(|error| OidnError::NoLibrary(reason(&error)))?;
        Ok(Self {
            new_device: function(&library, "oidnNewDevice")?,
            commit_device: function(&library, "oidnCommitDevice")?,
            release_device: function(&library, "oidnReleaseDevice")?,
            get_device_int: function(&library, "oidnGetDeviceInt")?,
            get_device_error: function(&library, "oidnGetDeviceError")?,
            new_filter: function(&library, "oidnNewFilter")?,
            release_filter: function(&library, "oidnReleaseFilter")?,
            set_filter_bool: function(&library, "oidnSetFilterBool")?,
            set_image: function(&library, "oidnSetSharedFilterImage")?,
            commit_filter: function(&library, "oidnCommitFilter")?,
            execute_filter: function(&library, "oidnExecuteFilter")?,
            _library: library,
        })
    }
}

/// A function of the library; `F` is its signature.
fn function<F: Copy>(library: &Library, name: &str) -> Result<F, OidnError> {
    // SAFETY: `F` is the signature that the header of version 2 gives `name`: each is written down once, in `Api`.
    let symbol = unsafe { library.get::<F>(name) };
    symbol
        .map(|symbol| *symbol)
        .map_err(|_| OidnError::TooOld(name.to_owned()))
}

/// The loader's message, in one line.
fn reason(error: &libloading::Error) -> String {
    let source = std::error::Error::source(error).map(ToString::to_string);
    let reason = source.unwrap_or_else(|| error.to_string());
    reason.split_whitespace().collect::<Vec<_>>().join(" ")
}
