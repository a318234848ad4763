//! The Vulkan device that tests run on.
//!
//! `VKPT_TEST_DEVICE` picks it (part of a name, or an index; default: the best). A test that finds no device fails,
//! unless `VKPT_TEST_NO_GPU=1` says outright that the run goes without.

#![allow(dead_code, reason = "each of the three crates uses a part of it")]

pub mod checks;
pub mod icosphere;
pub mod meshes;
pub mod pages;
pub mod render;
pub mod scenes;
pub mod settings;
pub mod spirv_tools;
pub mod stats;

use std::sync::OnceLock;

use vkpt::gpu::{Device, GpuError, Options, Selector};

/// One device for all tests of a crate, under the validation layer where that is installed. `None`: the run goes
/// without.
pub fn device() -> Option<&'static Device> {
    static DEVICE: OnceLock<Option<Device>> = OnceLock::new();
    DEVICE.get_or_init(|| open(Options::default())).as_ref()
}

/// The device that is asked for.
pub fn selector() -> Selector {
    std::env::var("VKPT_TEST_DEVICE").map_or(Selector::Best, |name| Selector::from(name.as_str()))
}

/// A device of one's own, opened with `options` and with validation where that is installed.
pub fn open(options: Options) -> Option<Device> {
    if std::env::var_os("VKPT_TEST_NO_GPU").is_some_and(|v| v == "1") {
        println!("skipped: VKPT_TEST_NO_GPU=1");
        return None;
    }
    let selector = selector();
    let opened = match Device::open_with(
        &selector,
        Options {
            validation: true,
            ..options.clone()
        },
    ) {
        Err(e @ GpuError::NoValidationLayer) => {
            println!("not validated: {e}");
            Device::open_with(&selector, options)
        }
        other => other,
    };
    Some(
        opened.unwrap_or_else(|e| {
            panic!("{e}\n(VKPT_TEST_NO_GPU=1 runs the tests that need no device)")
        }),
    )
}
