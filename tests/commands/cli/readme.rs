//! README.md tells the truth about flags and scene files.

use std::path::Path;

use super::program::{folder, run};

const README: &str = include_str!("../../../README.md");

#[test]
fn readme_and_help_name_the_same_flags() {
    let folder = folder("");
    let help_of = |arguments: &[&str]| run(folder.path(), arguments).out;
    let commands = [
        "check", "compare", "converge", "doctor", "explain", "export", "test",
    ];
    let commands = commands.map(|command| vec![command, "--help"]);
    let all = [vec!["render", "--help"], vec!["farm", "slurm", "--help"]];
    let all = all.iter().chain(&commands);
    let help: String = all.map(|words| help_of(words)).collect();
    let in_help = help
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix("--"));
    for flag in in_help.filter_map(|line| line.split_whitespace().next()) {
        assert!(
            README.contains(&format!("`--{flag}")),
            "README.md lacks --{flag}"
        );
    }
    let in_readme = README.lines().filter_map(|line| line.strip_prefix("| `--"));
    for flag in in_readme.filter_map(|line| line.split([' ', '`']).next()) {
        assert!(help.contains(&format!("--{flag}")), "--help lacks --{flag}");
    }
}

#[test]
fn the_example_scene_is_read_without_a_word() {
    let example = README
        .split("```\n")
        .find(|block| block.starts_with("screen "))
        .expect("an example");
    let read =
        vkpt::scene::parse(example, Path::new("README.md"), true).expect("no error, no warning");
    assert_eq!(
        (read.scene.shapes.len(), read.scene.materials.len()),
        (3, 3)
    );
}
