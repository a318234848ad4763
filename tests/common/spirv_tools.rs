//! The tools of Khronos' SPIR-V Tools, where they are installed.

use std::io::Write as _;
use std::process::Command;

/// Standard output of a tool that must succeed, or `None`, with a message, where it is not installed.
pub fn tool(name: &str, args: &[&str], input: &[u8]) -> Option<String> {
    try_tool(name, args, input).map(|r| r.unwrap_or_else(|e| panic!("{name}: {e}")))
}

/// Standard output, or standard error of a tool that fails.
pub fn try_tool(name: &str, args: &[&str], input: &[u8]) -> Option<Result<String, String>> {
    let mut file = tempfile::NamedTempFile::new().expect("a temporary file");
    file.write_all(input).expect("a temporary file");
    match Command::new(name).args(args).arg(file.path()).output() {
        Ok(o) if o.status.success() => Some(Ok(String::from_utf8_lossy(&o.stdout).into_owned())),
        Ok(o) => Some(Err(String::from_utf8_lossy(&o.stderr).into_owned())),
        Err(e) => {
            println!("skipped: {name} (Debian: spirv-tools): {e}");
            None
        }
    }
}
