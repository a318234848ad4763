//! Phrases that CONTRIBUTING.md, "Plain English" replaces: pages, help and sources have none of them.
//!
//! The list has only phrases that are never right. Records of measurements (docs/records/) keep their words.

use std::fs;
use std::path::Path;

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

/// The findings of a file, or of the files of a folder and of those in it.
fn search(path: &Path, all: &mut Vec<String>) {
    if path.ends_with("docs/records") || path.ends_with("python/.venv") {
        return;
    }
    if path.is_dir() {
        let entries = fs::read_dir(path).expect("a folder");
        entries.for_each(|entry| search(&entry.expect("an entry").path(), all));
    } else if path
        .extension()
        .is_some_and(|e| ENDINGS.iter().any(|&ending| e == ending))
    {
        let text = fs::read_to_string(path).expect("a text");
        all.extend(
            findings(&text)
                .iter()
                .map(|found| format!("{}:{found}", path.display())),
        );
    }
}

#[test]
fn no_page_or_source_has_them() {
    let mut all = Vec::new();
    FOLDERS
        .iter()
        .chain(&PAGES)
        .for_each(|path| search(Path::new(path), &mut all));
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
