//! The tools of Khronos' SPIR-V Tools.

use std::io::Write as _;
use std::process::Command;

use super::needs::Need;

/// Standard output of a tool that must succeed; `None` if the run skips it.
pub fn tool(name: &str, args: &[&str], input: &[u8]) -> Option<String> {
    try_tool(name, args, input).map(|r| r.unwrap_or_else(|e| panic!("{name}: {e}")))
}

/// Standard output, or standard error of a tool that fails.
pub fn try_tool(name: &str, args: &[&str], input: &[u8]) -> Option<Result<String, String>> {
    let mut file = tempfile::NamedTempFile::new().expect("a temporary file");
    file.write_all(input).expect("a temporary file");
    let mut command = Command::new(name);
    command.args(args).arg(file.path());
    let run = || command.output().map_err(|e| format!("{name}: {e}"));
    let output = Need::SpirvTools.find(run)?;
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    Some(match output.status.success() {
        true => Ok(text(&output.stdout)),
        false => Err(text(&output.stderr)),
    })
}
