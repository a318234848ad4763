//! docs/tutorial.md shows its scenes as their files are, and the pictures that scripts/tutorial makes.
#![cfg(unix)]

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use crate::cli::program::{Run, finish, names, run};
use crate::common::root;

const PAGE: &str = include_str!("../../docs/tutorial.md");

/// The folder of its scenes and pictures.
fn at() -> PathBuf {
    root().join("docs/tutorial")
}

/// The most bytes of all pictures.
const BYTES: u64 = 1_500_000;

/// Pictures that take a second or two: a diffuse surface, glass, rough metal, and a model other than the default one.
const CHEAP: [&str; 4] = ["sphere", "depth-3", "connect-light", "floor-direct"];

/// A scene that the page shows.
#[derive(Debug, PartialEq, Eq)]
struct Block<'a> {
    file: &'a str,
    excerpt: bool,
    text: &'a str,
}

/// The blocks below a line that ends with a link to a scene and a colon; `From` begins the line of an excerpt.
fn blocks(page: &str) -> Vec<Block<'_>> {
    let mut blocks = Vec::new();
    for (at, fence) in page.match_indices(".txt):\n\n```text\n") {
        let label = page[..at].rsplit('\n').next().unwrap_or_default();
        let (_, file) = label.rsplit_once("](tutorial/").expect("a link");
        let (text, _) = page[at + fence.len()..]
            .split_once("```")
            .expect("the block ends");
        blocks.push(Block {
            file,
            excerpt: label.starts_with("From "),
            text,
        });
    }
    blocks
}

/// Whether the block is the file, or lines of it that follow one another.
fn agrees(block: &Block, file: &str) -> bool {
    match block.excerpt {
        true => format!("\n{file}").contains(&format!("\n{}", block.text)),
        false => block.text == file,
    }
}

/// The pictures that the page shows.
fn shown(page: &str) -> BTreeSet<String> {
    let links = page.split("](tutorial/").skip(1);
    let files = links.filter_map(|link| link.split_once(')'));
    let pictures = files.filter_map(|(file, _)| file.strip_suffix(".png"));
    pictures.map(str::to_owned).collect()
}

fn with_ending(ending: &str) -> BTreeSet<String> {
    let names = names(&at());
    let names = names.iter().filter_map(|name| name.strip_suffix(ending));
    names.map(str::to_owned).collect()
}

fn script(arguments: &[&str]) -> Run {
    let mut script = Command::new(root().join("scripts/tutorial"));
    let script = script.args(arguments);
    finish(script.env("VKPT", env!("CARGO_BIN_EXE_vkpt")))
}

#[test]
fn every_scene_has_no_warning_and_describes_itself() {
    for name in with_ending(".txt") {
        let file = format!("{name}.txt");
        let explained = run(&at(), &["explain", &file, "--strict"]);
        assert_eq!(explained.code, Some(0), "{name}: {}", explained.err);
        assert!(!explained.err.contains("warning"), "{}", explained.err);
        let scene = fs::read_to_string(at().join(&file)).expect("a scene");
        let comment = scene.lines().take_while(|line| line.starts_with("# "));
        assert!((2..=6).contains(&comment.count()), "{name}");
        assert!(PAGE.contains(&format!("(tutorial/{file})")), "{name}");
    }
}

#[test]
fn scenes_of_the_page_are_those_of_their_files() {
    let blocks = blocks(PAGE);
    assert!(blocks.len() > 8, "{blocks:#?}");
    assert_eq!(blocks.len(), PAGE.matches("```text\n").count());
    for block in blocks {
        let path = at().join(format!("{}.txt", block.file));
        let file = fs::read_to_string(path).expect("the file of a block");
        assert!(agrees(&block, &file), "{block:#?}");
    }
}

#[test]
fn a_block_that_differs_is_found() {
    let page = "[a.txt](tutorial/a.txt):\n\n```text\none\ntwo\n```\n\nFrom [b.txt](tutorial/b.txt):\n\n```text\ntwo\n```\n";
    let found = blocks(page);
    let files = found.iter().map(|block| (block.file, block.excerpt));
    assert_eq!(files.collect::<Vec<_>>(), [("a", false), ("b", true)]);
    assert!(agrees(&found[0], "one\ntwo\n") && !agrees(&found[0], "one\ntwo\nthree\n"));
    assert!(agrees(&found[1], "one\ntwo\nthree\n") && !agrees(&found[1], "one two\n"));
    assert!(!agrees(&found[1], "one\ntwo three\n"));
}

#[test]
fn the_page_shows_each_picture_that_the_script_makes() {
    let listed = script(&["--list"]);
    assert_eq!(listed.code, Some(0), "{}", listed.err);
    let listed: BTreeSet<String> = listed.out.lines().map(str::to_owned).collect();
    assert_eq!(listed, shown(PAGE));
    assert_eq!(listed, with_ending(".png"));
    let size =
        |name: &String| fs::metadata(at().join(format!("{name}.png"))).map_or(0, |m| m.len());
    assert!(listed.iter().map(size).sum::<u64>() < BYTES);
}

#[test]
fn cheap_pictures_are_made_again_to_the_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_string_lossy();
    let arguments: Vec<&str> = [&*out].into_iter().chain(CHEAP).collect();
    let made = script(&arguments);
    assert_eq!(made.code, Some(0), "{}", made.err);
    assert_eq!(names(folder.path()).len(), CHEAP.len());
    for name in CHEAP {
        let file = format!("{name}.png");
        let now = fs::read(folder.path().join(&file)).expect("a picture");
        let kept = fs::read(at().join(&file)).expect("a picture that is kept");
        assert!(now == kept, "{name}");
    }
}
