//! Code that the three crates of tests share; here the Vulkan device that they run on.
//!
//! `VKPT_TEST_DEVICE` picks it (part of a name, or an index; default: the best). A test that finds none fails, unless
//! the run skips devices (`needs`).

#![allow(dead_code, reason = "each of the three crates uses a part of it")]

pub mod checks;
pub mod data;
pub mod defocus;
pub mod facets;
pub mod files;
pub mod gltf_writer;
pub mod icosphere;
pub mod meshes;
pub mod models;
pub mod needs;
pub mod pages;
pub mod render;
pub mod scenes;
pub mod settings;
pub mod spirv_tools;
pub mod stats;
pub mod surroundings;
pub mod table;

use std::path::Path;
use std::sync::OnceLock;

use needs::Need;
use vkpt::gpu::{Device, DeviceKind, GpuError, Options, Selector};

/// The repository. Tests of vkpt-cli begin in `cli/`, others here.
pub fn root() -> &'static Path {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let is_root = |folder: &&Path| folder.join("ARCHITECTURE.md").exists();
    package.ancestors().find(is_root).expect("the repository")
}

/// One device for all tests of a crate, under the validation layer. `None`: the run skips devices.
pub fn device() -> Option<&'static Device> {
    static DEVICE: OnceLock<Device> = OnceLock::new();
    Need::Device.find(|| {
        let open = || opened(Options::default()).unwrap_or_else(|e| Need::Device.fail(e));
        Ok::<_, GpuError>(DEVICE.get_or_init(open))
    })
}

/// The same, if it rounds ÷ and √ correctly, as CPU drivers do: only there are its bits the reference's.
pub fn cpu_driver() -> Option<&'static Device> {
    let device = device()?;
    Need::CpuDriver.find(|| match device.info().kind {
        DeviceKind::Cpu => Ok(device),
        _ => Err(format!(
            "{} is no CPU driver, and only CPU drivers must give the reference's bits; VKPT_TEST_DEVICE picks another",
            device.info().name
        )),
    })
}

/// The requested device.
pub fn selector() -> Selector {
    std::env::var("VKPT_TEST_DEVICE").map_or(Selector::Best, |name| Selector::from(name.as_str()))
}

/// A separate device, opened with `options` and under the validation layer.
pub fn open(options: Options) -> Option<Device> {
    Need::Device.find(|| opened(options))
}

/// Under the validation layer, unless the run skips it.
fn opened(options: Options) -> Result<Device, GpuError> {
    let validation = !Need::Validation.waived();
    let options = Options {
        validation,
        ..options
    };
    match Device::open_with(&selector(), options) {
        Err(e @ GpuError::NoValidationLayer) => Need::Validation.fail(e),
        opened => opened,
    }
}
