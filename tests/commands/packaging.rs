//! Files of packages other than the program: man pages, completions, and names that match.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::cli::program::{finish, names};

#[path = "../../cli/examples/packaging/files.rs"]
mod files;

const MANIFEST: &str = include_str!("../../cli/Cargo.toml");
const SCRIPT: &str = include_str!("../../scripts/package");

fn written() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    files::write(folder.path()).expect("files");
    folder
}

#[test]
fn each_command_has_a_man_page_with_its_options() {
    let folder = written();
    let man = folder.path().join("man");
    let pages = names(&man);
    for command in [
        "check",
        "compare",
        "converge",
        "devices",
        "doctor",
        "explain",
        "export",
        "farm-slurm",
        "init",
        "merge",
        "render",
        "test",
    ] {
        assert!(pages.contains(&format!("vkpt-{command}.1")), "{pages:?}");
    }
    let text = |name: &str| fs::read_to_string(man.join(name)).expect(name);
    for (page, option) in [
        ("vkpt.1", "\\-\\-roulette"),
        ("vkpt-render.1", "\\-\\-roulette"),
        ("vkpt-compare.1", "\\-\\-heatmap"),
    ] {
        assert!(text(page).contains(option), "{page} lacks {option}");
    }
    assert!(text("vkpt-render.1").contains("Exit codes:"));
}

/// bash's completions for the last of some words.
fn offered(completions: &Path, words: &[&str]) -> Vec<String> {
    let last = words.len() - 1;
    let script = format!(
        "source '{}'; COMP_WORDS=({}); COMP_CWORD={last}; _vkpt vkpt '{}' '{}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
        completions.join("vkpt").display(),
        words.join(" "),
        words[last],
        words[last - 1],
    );
    let run = finish(Command::new("bash").args(["-c", &script]));
    assert_eq!(run.code, Some(0), "{}", run.err);
    run.out.lines().map(str::to_owned).collect()
}

#[test]
fn bash_completes_commands_and_options() {
    let folder = written();
    let completions = folder.path().join("completions");
    assert_eq!(names(&completions), ["_vkpt", "vkpt", "vkpt.fish"]);
    assert_eq!(offered(&completions, &["vkpt", "conv"]), ["converge"]);
    let options = offered(&completions, &["vkpt", "render", "--ro"]);
    assert_eq!(options, ["--roulette"]);
    // Also those that the first page of help omits.
    assert_eq!(offered(&completions, &["vkpt", "--ro"]), ["--roulette"]);
    let options = offered(&completions, &["vkpt", "export", "--t"]);
    assert_eq!(options, ["--to"]);
}

/// Each file in the .deb exists, or is written by `scripts/package`.
#[test]
fn the_deb_is_made_of_files_that_there_are() {
    let root = crate::common::root();
    let folder = written();
    let (_, assets) = MANIFEST.split_once("assets = [\n").expect("assets");
    let (assets, _) = assets.split_once("\n]").expect("an end");
    let mut found = 0;
    for line in assets.lines() {
        let path = line.split('"').nth(1).expect("a path");
        let path = path.strip_prefix("../").unwrap_or(path);
        let (at, path) = match path.strip_prefix("target/packaging/") {
            Some(path) => (folder.path(), path),
            None => (root, path),
        };
        let is_there = match path.split_once('*') {
            Some((folder, ending)) => names(&at.join(folder))
                .iter()
                .any(|name| name.ends_with(ending)),
            None => at.join(path).exists() || path == "target/release/vkpt",
        };
        assert!(is_there, "{line}");
        found += 1;
    }
    assert!(found > 5);
}

#[test]
fn the_archive_has_the_name_that_binstall_looks_for() {
    let value = |key: &str| {
        let line = MANIFEST.lines().find_map(|line| line.strip_prefix(key));
        line.expect(key).trim_matches(['"', ' ', '=']).to_owned()
    };
    let filled = |template: String| {
        let parts = [
            ("version", "$version"),
            ("target", "$host"),
            ("bin", "vkpt"),
            ("binary-ext", ""),
        ];
        let fill =
            |text: String, (part, by): &(&str, &str)| text.replace(&format!("{{ {part} }}"), by);
        parts.iter().fold(template, fill)
    };
    let url = filled(value("pkg-url"));
    assert!(url.ends_with("/vkpt-$version-$host.tar.gz"), "{url}");
    assert_eq!(filled(value("bin-dir")), "vkpt-$version-$host/vkpt");
    for line in [
        "name=vkpt-$version-$host\n",
        "\"$folder.tar.gz\" \"$name\"\n",
    ] {
        assert!(SCRIPT.contains(line), "{line}");
    }
}
