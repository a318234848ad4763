//! Output that pages show is that of the program: the same words and columns; figures may differ.

use std::fs;

use crate::cli::program::{SCENE, folder, run, without_vulkan, words};
use crate::common::root;

const GPU: &str = include_str!("../../docs/gpu.md");
const MEASURE: &str = include_str!("../../docs/measure.md");
const TRUST: &str = include_str!("../../docs/trust.md");

/// The block without a language that contains `words`.
fn block<'p>(page: &'p str, words: &str) -> &'p str {
    let blocks = page.split("```").skip(1).step_by(2);
    let mut plain = blocks.filter_map(|block| block.strip_prefix('\n'));
    plain
        .find(|block| block.contains(words))
        .unwrap_or_else(|| panic!("no block with {words}"))
}

/// The text with each number, and each unit of time after one, as `#`.
fn shape(text: &str) -> String {
    let words = text.split(' ').map(|word| {
        let rest = word.trim_start_matches(|c: char| c.is_ascii_digit() || ".,-e".contains(c));
        let is_number = word.starts_with(|c: char| c.is_ascii_digit());
        match is_number || ["ms", "s", "min"].contains(&word.trim_end_matches(':')) {
            true => format!("#{}", rest.trim_start_matches(char::is_alphabetic)),
            false => word.to_owned(),
        }
    });
    let mut words: Vec<String> = words.collect();
    // A duration may have one unit or two.
    words.dedup_by(|a, b| a.starts_with('#') && *b == "#");
    words.join(" ")
}

fn shapes(text: &str) -> Vec<String> {
    text.lines().map(|line| shape(line.trim_end())).collect()
}

/// The rows of a table, without its header: the text before the first wide gap.
fn rows(table: &str) -> Vec<&str> {
    let labels = table.lines().skip(1).map(|line| {
        let indent = line.len() - line.trim_start().len();
        let label = line[indent..].split("  ").next().unwrap_or_default();
        &line[..indent + label.len()]
    });
    labels.collect()
}

#[test]
fn the_table_of_paired_comparisons_has_the_rows_of_its_page() {
    if without_vulkan() {
        return;
    }
    let folder = folder(SCENE);
    let run = run(
        folder.path(),
        &["compare", "--paired", "scene.scn", "--spp", "2"],
    );
    assert_eq!(run.code, Some(0), "{}", run.err);
    let shown = rows(block(MEASURE, "equal to the bit"));
    let table = run.out.split("\n\n").nth(1).expect("a table");
    assert_eq!(rows(table), shown);
}

#[test]
fn the_lines_of_test_have_the_shape_of_their_page() {
    let folder = folder("");
    let path = |name: &str| folder.path().join(name);
    fs::create_dir_all(path("p/glass")).expect("a folder");
    fs::write(path("p/box.txt"), SCENE).expect("a scene");
    fs::write(path("p/glass/ball.txt"), SCENE).expect("a scene");
    let blessed = words(folder.path(), "test p --spp 2 --bless");
    assert_eq!(blessed.code, Some(0), "{}", blessed.err);
    let brighter = SCENE.replace("1 1 1", "2 1 1");
    fs::write(path("p/glass/ball.txt"), brighter).expect("a scene");
    let run = words(folder.path(), "test p --spp 2");
    assert_eq!(run.code, Some(1), "{}", run.err);
    assert_eq!(shapes(&run.out), shapes(block(TRUST, "DIFFERS")));
}

#[test]
fn the_lines_of_explain_are_those_of_their_page() {
    let scene = root().join("scenes/glass-table.txt");
    let run = run(root(), &["explain", &scene.to_string_lossy()]);
    assert_eq!(run.code, Some(0), "{}", run.err);
    for line in block(GPU, "smooth dielectric").lines() {
        let is_there = run.out.lines().any(|l| l.trim_end() == line);
        assert!(is_there, "{line}\n{}", run.out);
    }
}

#[test]
fn the_last_line_names_the_reference_as_on_its_page() {
    let folder = folder(SCENE);
    let run = words(folder.path(), "scene.scn --spp 2");
    assert_eq!(run.code, Some(0), "{}", run.err);
    let end = |text: &str| {
        let last = text.trim_end().lines().last().expect("a line");
        last.rsplit(" · ").next().expect("an end").to_owned()
    };
    assert_eq!(end(&run.out), end(block(GPU, "on cpu-f32")));
}

#[test]
fn other_words_and_columns_are_seen() {
    assert_eq!(
        shape("2 scenes in 4.1 ms: 1 failed"),
        shape("3 scenes in 1 min 02 s: 2 failed")
    );
    assert_ne!(shape("1 failed"), shape("1 went wrong"));
    assert_ne!(shape("relMSE 2.3e-4; 5"), shape("relMSE 2.3e-04 5"));
    assert_eq!(
        rows("      a  b\npaths  1  2\n  part of all   3\n"),
        ["paths", "  part of all"]
    );
}
