//! One run of the program.

use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use serde_json::{Value, json};

use super::Arguments;

/// The purpose of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One sample without caches.
    Cold,
    /// Fills the caches.
    Fill,
    /// One sample with them.
    Warm,
    /// Many samples.
    Render,
}

/// A run and its report.
pub struct Run {
    pub scene: String,
    pub kind: Kind,
    pub full: bool,
    /// The program's report, with `kind` and the seconds of the `whole` process.
    pub json: Value,
}

impl Run {
    /// A number of the report by its path, such as `/seconds/compile`; NaN if it is missing.
    pub fn number(&self, path: &str) -> f64 {
        let value = self.json.pointer(path).and_then(Value::as_f64);
        value.unwrap_or(f64::NAN)
    }
}

/// Renders `scene` in its own process.
pub fn run(
    arguments: &Arguments,
    scene: &Path,
    kind: Kind,
    full: bool,
) -> Result<Run, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let (picture, report) = (folder.path().join("x.png"), folder.path().join("x.json"));
    let spp = if kind == Kind::Render {
        arguments.spp
    } else {
        1
    };
    let mut command = Command::new(env!("CARGO_BIN_EXE_vkpt"));
    command
        .arg(scene)
        .args(["--quiet", "--size", &arguments.size]);
    command.args(["--spp", &spp.to_string()]);
    command.args(["--kernel", if full { "full" } else { "composed" }]);
    command.arg("-o").arg(&picture).arg("--json").arg(&report);
    if let Some(device) = &arguments.device {
        command.args(["--device", device]);
    }
    if kind == Kind::Cold {
        command
            .env("VKPT_CACHE", "")
            .env("MESA_SHADER_CACHE_DISABLE", "true");
    }
    let start = Instant::now();
    let output = command.output()?;
    let whole = start.elapsed().as_secs_f64();
    if !output.status.success() {
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(format!("{}: {stderr}", scene.display()).into());
    }
    let mut json: Value = serde_json::from_slice(&std::fs::read(&report)?)?;
    // The folder is gone.
    json["files"] = json!([]);
    json["kind"] = json!(format!("{kind:?}").to_lowercase());
    json["whole"] = json!(whole);
    let name = scene.file_stem().unwrap_or_default().to_string_lossy();
    Ok(Run {
        scene: name.into_owned(),
        kind,
        full,
        json,
    })
}
