//! The commands of docs/farm.md, with a program that stands for vkpt.

use std::fs;
use std::process::Command;

use tempfile::TempDir;

use super::folder::one_run;
use crate::cli::program::{Run, SCENE, finish, names, words};
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

/// A folder with the page's scene, in whose `bin` vkpt and ssh are.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let bin = folder.path().join("bin");
    fs::create_dir(&bin).expect("a folder");
    fs::write(folder.path().join("glass.txt"), SCENE).expect("a scene");
    program(&bin, "vkpt", include_str!("vkpt.sh"));
    program(&bin, "ssh", "cd /\nexec bash -c \"$2\"");
    folder
}

/// Runs a program with `text` as its file, in the page's folder; gives the picture.
fn picture(interpreter: &str, text: &str) -> String {
    let folder = folder();
    let path = std::env::var("PATH").expect("PATH");
    let path = format!("{}:{path}", folder.path().join("bin").display());
    let file = folder.path().join("commands");
    fs::write(&file, text).expect("a file");
    let mut command = Command::new(interpreter);
    let command = command.arg(file).current_dir(folder.path());
    let Run { code, out, err } = finish(command.env("PATH", path));
    assert_eq!(code, Some(0), "{out}{err}");
    fs::read_to_string(folder.path().join("glass.exr")).expect("a picture")
}

/// What is missing where a command fails.
fn runs(words: &[&str]) -> Result<(), String> {
    let ran = Command::new(words[0]).args(&words[1..]).output();
    match ran.is_ok_and(|output| output.status.success()) {
        true => Ok(()),
        false => Err(format!("{} does not run", words.join(" "))),
    }
}

#[test]
fn slurm() {
    for heading in ["## Slurm", "### Rounds"] {
        let folder = folder();
        for line in block(heading, "sh").lines() {
            let line = line.split(" #").next().expect("a command").trim();
            match line.strip_prefix("vkpt ") {
                Some(arguments) => {
                    assert_eq!(words(folder.path(), arguments).code, Some(0), "{line}")
                }
                None => assert_eq!(line, "bash glass.farm/submit.sh"),
            }
        }
        assert!(names(&folder.path().join("glass.farm")).contains(&"submit.sh".to_owned()));
    }
}

#[test]
fn gnu_parallel() {
    if Need::Parallel
        .find(|| runs(&["parallel", "--version"]))
        .is_some()
    {
        assert_eq!(
            picture("bash", block("## GNU parallel", "sh")),
            one_run(1024)
        );
    }
}

#[test]
fn ssh() {
    assert_eq!(picture("bash", block("## ssh", "sh")), one_run(1024));
}

#[test]
fn dask() {
    if Need::Dask
        .find(|| runs(&["python3", "-c", "import distributed"]))
        .is_some()
    {
        assert_eq!(
            picture("python3", block("## Dask", "python")),
            one_run(1024)
        );
    }
}
