//! The files, by the program's own parser.

use std::fs;
use std::io;
use std::path::Path;

use clap_complete::Shell;
use vkpt_cli::command_line;

const SHELLS: [Shell; 3] = [Shell::Bash, Shell::Zsh, Shell::Fish];

/// `man/`: a page for `vkpt` and for each command; `completions/`: a file for each shell, under the name that the shell
/// looks for.
///
/// # Errors
/// A file or folder that cannot be written.
pub fn write(folder: &Path) -> io::Result<()> {
    let [man, completions] = ["man", "completions"].map(|name| folder.join(name));
    fs::create_dir_all(&man)?;
    fs::create_dir_all(&completions)?;
    clap_mangen::generate_to(command_line(), &man)?;
    for shell in SHELLS {
        clap_complete::generate_to(shell, &mut command_line(), "vkpt", &completions)?;
    }
    // bash looks for the name of the program.
    fs::rename(completions.join("vkpt.bash"), completions.join("vkpt"))
}
