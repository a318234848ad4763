//! Phrases that CONTRIBUTING.md, "Plain English" replaces: pages, help and sources have none of them.
//!
//! The list has only phrases that are never right. Records of measurements (docs/records/) keep their words.

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::files::below;

/// A phrase, and what to write.
const PHRASES: [(&str, &str); 8] = [
    ("by turns", "in alternation"),
    ("for want of", "for lack of"),
    ("goes on from", "resumes from"),
    ("held against", "compared with"),
    ("is told of", "hears of, or is given"),
    ("of one's own", "custom"),
    ("onlooker", "viewer"),
    ("is warned of", "gives a warning"),
];

const FOLDERS: [&str; 10] = [
    "benches", "cli/src", "docs", "examples", "lab/src", "python", "scenes", "scripts", "shaders",
    "src",
];
const PAGES: [&str; 3] = ["ARCHITECTURE.md", "CONTRIBUTING.md", "README.md"];
const ENDINGS: [&str; 8] = ["comp", "glsl", "js", "md", "py", "rs", "sh", "txt"];

/// `the phrase: write …`, once a line that has one. A line of CONTRIBUTING.md's list quotes a phrase.
fn findings(text: &str) -> Vec<String> {
    let lines = (1..).zip(text.lines().map(str::to_lowercase));
    let of = |(number, line): (usize, String)| {
        let has = move |phrase: &&(&str, &str)| {
            line.contains(phrase.0) && !line.contains(&format!("\"{}\"", phrase.0))
        };
        let found = PHRASES.iter().find(has);
        found.map(|(phrase, plain)| format!("{number}: \"{phrase}\": {plain}"))
    };
    lines.filter_map(of).collect()
}

#[test]
fn no_page_or_source_has_them() {
    let is_searched = |folder: &Path| !folder.ends_with("docs/records");
    let below = |folder: &&str| below(Path::new(folder), &is_searched);
    let pages = PAGES.iter().map(PathBuf::from);
    let mut all = Vec::new();
    for path in FOLDERS.iter().flat_map(below).chain(pages) {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        if ENDINGS.contains(&ending) {
            let text = fs::read_to_string(&path).expect("a text");
            let found = findings(&text).into_iter();
            all.extend(found.map(|found| format!("{}:{found}", path.display())));
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn a_planted_phrase_is_found() {
    let found = findings(
        "// All is well.\n// What is held against it\nwrite \"held against\" as \"compared with\"\nHeld Against",
    );
    assert_eq!(
        found,
        [
            "2: \"held against\": compared with",
            "4: \"held against\": compared with"
        ]
    );
}
