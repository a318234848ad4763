//! Submits the jobs of a folder to Slurm.

use std::path::Path;
use std::process::{Command, Stdio};

use vkpt_lab::cli::exit::Failure;

/// Runs `submit.sh` and returns its output, the numbers of the jobs.
pub fn submit(script: &Path) -> Result<String, Failure> {
    let output = Command::new("bash")
        .arg(script)
        .stdin(Stdio::null())
        .output();
    let failed = |why: &str| Failure::Submission(format!("{}: {why}", script.display()));
    let output = output.map_err(|error| failed(&format!("cannot run bash: {error}")))?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    match output.status.success() {
        true => Ok(text(&output.stdout)),
        false => Err(failed(text(&output.stderr).trim_end())),
    }
}
