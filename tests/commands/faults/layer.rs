//! The layer that makes calls fail, built for a test.

use std::collections::BTreeMap;
use std::fs;

use std::process::Command;

use tempfile::TempDir;

use super::trial::{Trial, command, finish};
use crate::common::needs::Need;

/// Entry points that it knows: all that may fail and that a rendering calls.
pub const CALLS: usize = 25;

/// A folder with the layer, for the loader to find.
pub struct Layer(TempDir);

impl Layer {
    /// `None` if the run skips it.
    pub fn built() -> Option<Self> {
        if Need::Lavapipe.skips() {
            return None;
        }
        Need::VulkanHeaders.find(build).map(Self)
    }

    /// Has a program find it.
    pub fn load(&self, command: &mut Command) {
        let folder = self.0.path();
        command
            .env("VK_LAYER_PATH", folder)
            .env("VK_INSTANCE_LAYERS", "VK_LAYER_VKPT_faults")
            // The pipeline cache is called as well, and finds nothing.
            .env("VKPT_CACHE", folder.join("cache"))
            .env_remove("VKPT_VALIDATION");
    }

    /// A rendering without faults, with the number of calls of each entry point.
    pub fn count(&self) -> (Trial, BTreeMap<String, usize>) {
        let counts = self.0.path().join("counts");
        let sound = finish(|folder| {
            let mut command = command(self, folder);
            command.env("VKPT_FAULT_COUNTS", &counts);
            command
        });
        let text = fs::read_to_string(&counts).expect("the layer's counts");
        let lines = text.lines().filter_map(|line| line.split_once(' '));
        let counts = lines.map(|(call, n)| (call.to_owned(), n.parse().expect("a number")));
        (sound, counts.collect())
    }
}

fn build() -> Result<TempDir, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let source = crate::common::root().join("tests/commands/faults");
    let ran = Command::new("cc")
        .args(["-shared", "-fPIC", "-Wall", "-Wextra", "-Werror"])
        .args(["-Wl,-z,nodelete", "-o"])
        .arg(folder.path().join("layer.so"))
        .arg(source.join("layer.c"))
        .output()
        .map_err(|e| format!("cc: {e}"))?;
    if !ran.status.success() {
        return Err(String::from_utf8_lossy(&ran.stderr).into_owned());
    }
    fs::copy(source.join("layer.json"), folder.path().join("layer.json"))
        .map_err(|e| e.to_string())?;
    Ok(folder)
}
