//! Comments that cite docs/model.md cite headings that it has, and each of its checks is cited by a test.
//!
//! A citation has one form: model.md, a comma, the heading in quotation marks. `docs/model.md` names the whole page.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::files::below;

const PAGE: &str = "docs/model.md";
/// This file is no place to look in: it plants wrong citations.
const FOLDERS: [&str; 8] = [
    "benches", "cli", "examples", "fuzz", "lab", "shaders", "src", "tests",
];
const ENDINGS: [&str; 3] = ["rs", "glsl", "comp"];

/// Comments that run over several lines, as one line.
fn joined(text: &str) -> String {
    let words = text
        .lines()
        .map(|line| line.trim().trim_start_matches(['/', '!']).trim());
    words.collect::<Vec<_>>().join(" ")
}

/// The headings that a text cites, and the errors of its citations.
fn citations(text: &str) -> (Vec<String>, Vec<String>) {
    let text = joined(text);
    let (mut titles, mut wrong) = (Vec::new(), Vec::new());
    for (at, name) in text.match_indices("model.md") {
        let rest = &text[at + name.len()..];
        let title = rest.strip_prefix(", \"").and_then(|r| r.split_once('"'));
        match title {
            Some((title, _)) => titles.push(title.to_owned()),
            None if text[..at].ends_with("docs/") => {}
            None => wrong.push(format!("no heading: model.md{}", excerpt(rest))),
        }
    }
    let lower = text.to_lowercase();
    for (at, _) in lower.match_indices("model page") {
        wrong.push(format!("a page by another name: {}", excerpt(&lower[at..])));
    }
    for (at, word) in lower.match_indices("section") {
        let after = lower[at + word.len()..].trim_start_matches('s');
        let numbered = after
            .strip_prefix(' ')
            .is_some_and(|after| after.starts_with(|c: char| c.is_ascii_digit()));
        if numbered && !lower[..at].ends_with(", ") {
            wrong.push(format!("a section of what? {}", excerpt(&lower[at..])));
        }
    }
    (titles, wrong)
}

fn excerpt(text: &str) -> String {
    text.chars().take(40).collect()
}

/// A heading, and how deep it is.
fn headings(page: &str) -> Vec<(usize, String)> {
    page.lines()
        .filter(|line| line.starts_with('#'))
        .map(|line| {
            let title = line.trim_start_matches('#');
            (line.len() - title.len(), title.trim().to_owned())
        })
        .collect()
}

/// The errors of a text's citations.
fn complaints(text: &str, headings: &[(usize, String)]) -> Vec<String> {
    let (titles, mut wrong) = citations(text);
    let known = |title: &String| headings.iter().any(|(_, h)| h == title);
    let unknown = titles.iter().filter(|title| !known(title));
    wrong.extend(unknown.map(|title| format!("{PAGE} has no heading \"{title}\"")));
    wrong
}

/// Every source file, with its text.
fn all_sources() -> Vec<(String, String)> {
    let is_kept = |folder: &Path| !folder.ends_with("target");
    let files = FOLDERS
        .iter()
        .flat_map(|folder| below(Path::new(folder), &is_kept));
    let is_source = |path: &PathBuf| {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        ENDINGS.contains(&ending) && !path.ends_with("citations.rs")
    };
    let text = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("a source file");
        (path.display().to_string(), text)
    };
    files.filter(is_source).map(text).collect()
}

fn page() -> Vec<(usize, String)> {
    headings(&fs::read_to_string(PAGE).unwrap_or_else(|e| panic!("{PAGE}: {e}")))
}

#[test]
fn citations_name_headings_of_the_page() {
    let headings = page();
    let (mut wrong, mut cited) = (Vec::new(), 0);
    for (path, text) in all_sources() {
        cited += citations(&text).0.len();
        let found = complaints(&text, &headings);
        wrong.extend(found.into_iter().map(|c| format!("{path}: {c}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(cited > 50, "only {cited} citations were found");
}

#[test]
fn headings_are_unambiguous() {
    let headings = page();
    let titles: BTreeSet<_> = headings.iter().map(|(_, title)| title).collect();
    assert_eq!(titles.len(), headings.len(), "{headings:?}");
}

/// Each heading below "Checks" is cited by a test: the page promises no check that does not exist.
#[test]
fn every_check_is_made() {
    let headings = page();
    let start = headings.iter().position(|(_, title)| title == "Checks");
    let checks = headings[start.expect("a section \"Checks\"") + 1..]
        .iter()
        .take_while(|(depth, _)| *depth > 2);
    let cited: BTreeSet<String> = all_sources()
        .iter()
        .filter(|(path, _)| path.starts_with("tests"))
        .flat_map(|(_, text)| citations(text).0)
        .collect();
    let missing: Vec<_> = checks.filter(|(_, t)| !cited.contains(t)).collect();
    assert!(missing.is_empty(), "no test cites {missing:?}");
}

#[test]
fn wrong_citations_are_found() {
    let headings = headings("# The page\n## Limits\n### The null interface\n");
    let right = "/// Not there (model.md,\n    /// \"The null interface\"), by docs/model.md.\n// HPG 2017, section 3.";
    assert_eq!(complaints(right, &headings), Vec::<String>::new());
    assert_eq!(citations(right).0, ["The null interface"]);
    for wrong in [
        "// (model.md, \"Limit\")",
        "// (model.md, \"limits\")",
        "//! (model.md, Limits)",
        "// (model.md)",
        "// (model.md, section 8)",
        "/// (model page, \"Limits\")",
        "// Model\n// page",
        "// by the limits (section 8)",
        "// Sections 2 to 8",
    ] {
        assert_eq!(complaints(wrong, &headings).len(), 1, "{wrong}");
    }
}
