//! Runs the built program in its own folder.

use std::fs;
use std::io;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

use crate::common::needs::Need;

/// A scene that any renderer can render in no time.
pub const SCENE: &str = "screen 8 6\ncamera 0 0 5 0.3\nlight 1 1 1\nsphere 0 0 0 1\n";

/// A triangle.
pub const MESH: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
    element face 1\nproperty list uchar int vertex_indices\nend_header\n-1 -1 0\n1 -1 0\n0 1 0\n3 0 1 2\n";

/// A scene with the mesh `m.ply`, which any other renderer has an equal of.
pub const MESHED: &str = "screen 8 6\ncamera 0 0 5 0.3\nbrdf .5 .5 .5 0 0 0 1 0 0 0 1\nmesh m.ply 0 0 0 1\nlight 1 1 1\nsphere 0 0 0 1\n";

/// The results of a run.
#[derive(Debug)]
pub struct Run {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// A folder that contains `scene.scn`.
pub fn folder(scene: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("scene.scn"), scene).expect("a scene file");
    folder
}

/// `vkpt` with `arguments` in `folder`.
pub fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_vkpt"));
    command
        .args(arguments)
        .current_dir(folder)
        .env("NO_COLOR", "1");
    command
}

/// Runs to its end.
pub fn run(folder: &Path, arguments: &[&str]) -> Run {
    finish(&mut command(folder, arguments))
}

/// Runs with the words of a line, separated by blanks.
pub fn words(folder: &Path, line: &str) -> Run {
    run(folder, &line.split(' ').collect::<Vec<_>>())
}

/// Runs a line of the shell in `folder`, where `$VKPT` is the program.
pub fn shell(folder: &Path, line: &str) -> Run {
    let mut shell = Command::new("bash");
    let shell = shell.args(["-c", line]).current_dir(folder);
    finish(
        shell
            .env("VKPT", env!("CARGO_BIN_EXE_vkpt"))
            .env("NO_COLOR", "1"),
    )
}

/// Runs a command to its end.
pub fn finish(command: &mut Command) -> Run {
    let output = command.output().expect("the program runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    Run {
        code: output.status.code(),
        out: text(output.stdout),
        err: text(output.stderr),
    }
}

/// A command line and its message, for a snapshot. The system's own words for a missing file are left out of it.
pub fn shown(arguments: &[&str], message: &str) -> String {
    let missing = io::Error::from_raw_os_error(2).to_string();
    let message = message.replace(&missing, "[no such file]");
    let command = [&["$ vkpt"], arguments].concat().join(" ");
    format!("{command}\n{message}\n")
}

/// The names in a folder, sorted.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").flatten();
    let mut names: Vec<_> = entries
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Whether the run skips Vulkan devices; otherwise the program fails if it finds none.
pub fn without_vulkan() -> bool {
    Need::Device.skips()
}
