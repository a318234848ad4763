//! The pages are right about flags and scene files. docs/cli.md is generated: it is the list of all flags.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use clap::{Arg, Command};
use vkpt_cli::command_line;

const README: &str = include_str!("../../README.md");
const FIRST_SCENE: &str = include_str!("../../docs/first-scene.txt");
const SCENES: &str = include_str!("../../docs/scenes.md");

/// Flags of other programs that pages name.
const FOREIGN: [&str; 15] = [
    "--dependency",
    "--example",
    "--jobs",
    "--joblog",
    "--locked",
    "--no-install",
    "--outfile",
    "--path",
    "--release",
    "--retries",
    "--signal",
    "--sshlogin",
    "--test",
    "--triangles",
    "--workdir",
];

/// README.md and the pages of `docs/`, but not its records, by their paths.
fn pages() -> Vec<(PathBuf, String)> {
    let root = crate::common::root();
    let docs = fs::read_dir(root.join("docs")).expect("docs").flatten();
    let paths = docs.map(|entry| entry.path());
    let pages = paths.filter(|path| path.extension().is_some_and(|ending| ending == "md"));
    let paths = pages.chain([root.join("README.md")]);
    let with_text = paths.map(|path| {
        let text = fs::read_to_string(&path).expect("a page");
        (path, text)
    });
    with_text.collect()
}

/// The flags that a text names.
fn named(text: &str) -> BTreeSet<String> {
    let places = text.match_indices("--");
    let flags = places.filter_map(|(at, _)| {
        let begins = !text[..at].ends_with(|c: char| c.is_alphanumeric() || "-|!".contains(c));
        let rest = &text[at + 2..];
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '-');
        let name = &rest[..end.unwrap_or(rest.len())];
        (begins && name.starts_with(|c: char| c.is_ascii_lowercase())).then(|| format!("--{name}"))
    });
    flags.collect()
}

/// The flags of a command and of those in it.
fn known(command: &Command) -> BTreeSet<String> {
    let own = command.get_arguments().filter_map(Arg::get_long);
    let own = own.map(|long| format!("--{long}"));
    let others = command.get_subcommands().flat_map(known);
    own.chain(others).collect()
}

#[test]
fn pages_name_no_flag_that_is_not_there() {
    let mut program = command_line();
    program.build();
    let known = known(&program);
    let mut unused: BTreeSet<&str> = BTreeSet::from(FOREIGN);
    for (path, text) in pages() {
        for flag in named(&text) {
            let is_foreign = unused.remove(&*flag) || FOREIGN.contains(&&*flag);
            let path = path.display();
            assert!(known.contains(&flag) || is_foreign, "{path}: {flag}");
        }
    }
    assert!(unused.is_empty(), "no page names {unused:?}");
}

#[test]
fn flags_are_found_in_text() {
    let found = named("`--spp N` a--b |---|---| <!-- c --> `--view[=<PORT>]`, --no-install; --");
    assert_eq!(Vec::from_iter(found), ["--no-install", "--spp", "--view"]);
}

/// The first block of a page that is a scene.
fn scene(page: &str) -> &str {
    let scene = page
        .split("```\n")
        .find(|block| block.starts_with("screen "));
    scene.expect("a scene")
}

#[test]
fn scenes_of_the_pages_are_read_without_a_word() {
    for (page, shapes, materials) in [(README, 4, 4), (SCENES, 3, 3)] {
        let read = vkpt::scene::parse(scene(page), Path::new("page.md"), true);
        let scene = read.expect("no error, no warning").scene;
        assert_eq!(
            (scene.shapes.len(), scene.materials.len()),
            (shapes, materials)
        );
    }
}

#[test]
fn the_first_scene_is_the_file_beside_its_picture() {
    assert_eq!(scene(README), FIRST_SCENE);
    assert_eq!(FIRST_SCENE.lines().count(), 12);
}
