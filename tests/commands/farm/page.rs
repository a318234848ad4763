//! The commands of docs/farm.md.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

use super::slurm::Slurm;
use crate::cli::program::{SCENE, finish, names, run};
use crate::common::needs::Need;
use crate::scripts::program::program;

const PAGE: &str = include_str!("../../../docs/farm.md");

/// The first block of a language below a heading.
fn block(heading: &str, language: &str) -> &'static str {
    let begin = format!("\n{heading}\n");
    let (_, below) = PAGE.split_once(&begin).expect("a heading");
    let fence = format!("```{language}\n");
    let (_, block) = below.split_once(&fence).expect("a block");
    block.split("```").next().expect("an end")
}

/// A folder with the page's scenes, in whose `bin` vkpt and ssh are.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["bin", "shots"] {
        fs::create_dir(folder.path().join(name)).expect("a folder");
    }
    for name in ["glass.txt", "shots/1.txt", "shots/2.txt"] {
        fs::write(folder.path().join(name), SCENE).expect("a scene");
    }
    let bin = folder.path().join("bin");
    symlink(env!("CARGO_BIN_EXE_vkpt"), bin.join("vkpt")).expect("a link");
    program(&bin, "ssh", "cd /\nexec bash -c \"$2\"");
    folder
}

/// Runs a block by a command in the folder.
fn run_block(folder: &Path, mut command: Command, block: &str) {
    let path = std::env::var("PATH").expect("PATH");
    let path = format!("{}:{path}", folder.join("bin").display());
    fs::write(folder.join("block"), block).expect("a file");
    let command = command.arg("block").current_dir(folder).env("PATH", path);
    let run = finish(command);
    assert_eq!(run.code, Some(0), "{}{}", run.out, run.err);
}

/// The block makes the picture of one run.
fn makes_the_picture(interpreter: &str, block: &str) {
    let folder = folder();
    run_block(folder.path(), Command::new(interpreter), block);
    let one = ["glass.txt", "--spp", "1024", "-o", "one.exr"];
    assert_eq!(run(folder.path(), &one).code, Some(0));
    let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a picture");
    assert!(bytes("glass.exr") == bytes("one.exr"));
}

/// The missing programs if a command fails.
fn runs(words: &[&str]) -> Result<(), String> {
    let ran = Command::new(words[0]).args(&words[1..]).output();
    match ran.is_ok_and(|output| output.status.success()) {
        true => Ok(()),
        false => Err(format!("{} does not run", words.join(" "))),
    }
}

#[test]
fn slurm() {
    let Some(slurm) = Slurm::start() else { return };
    for (heading, pictures) in [
        ("## Slurm", &["glass.exr", "glass.png"][..]),
        ("### Frames", &["1.exr", "1.png", "2.exr", "2.png"]),
    ] {
        let folder = folder();
        run_block(folder.path(), slurm.command("bash"), block(heading, "sh"));
        slurm.finish();
        let left = names(folder.path());
        assert!(
            pictures.iter().all(|p| left.iter().any(|name| name == p)),
            "{left:?}"
        );
    }
    // Which take minutes.
    for line in block("### Rounds", "sh").lines() {
        let words = line
            .split(" #")
            .next()
            .expect("a command")
            .split_whitespace();
        let words: Vec<&str> = words.skip(1).collect();
        assert_eq!(run(folder().path(), &words).code, Some(0), "{line}");
    }
}

#[test]
fn gnu_parallel() {
    if Need::Parallel
        .find(|| runs(&["parallel", "--version"]))
        .is_some()
    {
        makes_the_picture("bash", block("## GNU parallel", "sh"));
    }
}

#[test]
fn ssh() {
    makes_the_picture("bash", block("## ssh", "sh"));
}

#[test]
fn dask() {
    let imports = ["python3", "-c", "import distributed"];
    if Need::Dask.find(|| runs(&imports)).is_some() {
        makes_the_picture("python3", block("## Dask", "python"));
    }
}
