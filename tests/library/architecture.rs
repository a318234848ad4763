//! The arrows of ARCHITECTURE.md, held against the sources.

use std::path::{Path, PathBuf};

/// A room of `src/` and the rooms that it may name.
const ROOMS: [(&str, &[&str]); 21] = [
    ("settings", &[]),
    ("scene", &["settings"]),
    ("prepared", &["scene", "settings"]),
    ("features", &["film", "prepared", "settings"]),
    ("layout", &[]),
    ("flat", &["prepared", "layout"]),
    (
        "kernel",
        &[
            "features", "prepared", "settings", "layout", "flat", "sample",
        ],
    ),
    ("cache", &[]),
    ("gpu", &["cache", "kernel", "layout"]),
    ("reference", &["prepared", "sample", "settings"]),
    (
        "render",
        &[
            "features",
            "film",
            "flat",
            "gpu",
            "kernel",
            "layout",
            "metrics",
            "prepared",
            "reference",
            "sample",
            "settings",
        ],
    ),
    ("film", &[]),
    ("sample", &[]),
    ("image", &["film"]),
    ("metrics", &["film", "image", "sample"]),
    ("report", &["film", "image", "metrics", "settings"]),
    ("converge", &["film", "metrics", "render"]),
    (
        "doctor",
        &["gpu", "kernel", "reference", "render", "report"],
    ),
    (
        "explain",
        &[
            "features", "film", "flat", "kernel", "layout", "prepared", "render", "report",
            "settings",
        ],
    ),
    (
        "check",
        &[
            "film", "gpu", "metrics", "prepared", "render", "report", "sample", "scene", "settings",
        ],
    ),
    (
        "cli",
        &[
            "cache", "check", "converge", "doctor", "explain", "film", "gpu", "image", "metrics",
            "prepared", "render", "report", "sample", "scene", "settings",
        ],
    ),
];

/// A source file: its path below `src/`, and its text.
struct Source {
    path: String,
    text: String,
}

impl Source {
    fn room(&self) -> &str {
        self.path.split(['/', '.']).next().unwrap_or_default()
    }

    /// Lines of code with their numbers: no comments.
    fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        self.text
            .lines()
            .enumerate()
            .map(|(i, line)| (i + 1, line.split("//").next().unwrap_or_default()))
    }

    fn violation(&self, line: usize, what: &str) -> String {
        format!("src/{}:{line}: {what}", self.path)
    }
}

/// Everything in a source file that the architecture does not allow.
fn violations(source: &Source) -> Vec<String> {
    let mut all = arrows(source);
    let room = source.room();
    // Word, and the room that alone may use it.
    for (word, home) in [
        ("unsafe", "gpu"),
        ("ash::", "gpu"),
        ("naga::", "kernel"),
        ("unaudited::", "doctor"),
        ("println!", "cli"),
        ("print!", "cli"),
        ("dbg!", "cli"),
        ("std::process::exit", "cli"),
    ] {
        for (line, code) in source.lines() {
            if room != home && is_word_in(word, code) {
                all.push(source.violation(line, &format!("`{word}` outside {home}")));
            }
        }
    }
    all
}

/// `println!` is also in `eprintln!`, but `naga::` is not in `our_naga::`.
fn is_word_in(word: &str, code: &str) -> bool {
    let code = code.replace("eprint", "print");
    code.match_indices(word).any(|(i, _)| {
        let before = code[..i].chars().next_back();
        !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
    })
}

/// Uses of `crate::room` that ARCHITECTURE.md has no arrow for.
fn arrows(source: &Source) -> Vec<String> {
    let room = source.room();
    if matches!(room, "lib" | "main") {
        return Vec::new();
    }
    let Some((_, allowed)) = ROOMS.iter().find(|(name, _)| *name == room) else {
        return vec![source.violation(1, "a room that ARCHITECTURE.md does not know")];
    };
    let mut all = Vec::new();
    for (line, code) in source.lines() {
        for other in code.split("crate::").skip(1).flat_map(named) {
            let known = ROOMS.iter().any(|(name, _)| *name == other);
            if known && other != room && !allowed.contains(&other) {
                all.push(source.violation(line, &format!("{room} may not know {other}")));
            }
        }
    }
    all
}

/// The modules that follow `crate::`: one, or several in braces on one line.
fn named(path: &str) -> Vec<&str> {
    let list = path
        .strip_prefix('{')
        .map_or(vec![path], |list| list.split(',').collect());
    list.into_iter().map(first_name).collect()
}

fn first_name(path: &str) -> &str {
    let path = path.trim();
    let end = path.find(|c: char| !(c.is_alphanumeric() || c == '_'));
    &path[..end.unwrap_or(path.len())]
}

fn sources(folder: &Path) -> Vec<Source> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path: PathBuf = entry.path();
        if path.is_dir() {
            all.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            let below = path.strip_prefix("src").expect("a file of src");
            all.push(Source {
                path: below.to_string_lossy().replace('\\', "/"),
                text: std::fs::read_to_string(&path).expect("a text"),
            });
        }
    }
    all
}

#[test]
fn every_file_keeps_to_its_room() {
    let sources = sources(Path::new("src"));
    assert!(sources.len() > 100);
    let all: Vec<String> = sources.iter().flat_map(violations).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn a_planted_violation_is_found() {
    let found = |path: &str, text: &str| {
        let source = Source {
            path: path.into(),
            text: text.into(),
        };
        violations(&source)
    };
    let ok: [(&str, &str); 5] = [
        ("flat/mod.rs", "use crate::prepared::Prepared;"),
        ("gpu/device.rs", "// SAFETY: it is.\nunsafe { ash::x() }"),
        ("kernel/compile.rs", "use naga::Module;"),
        ("cli/render.rs", "println!(\"done\");"),
        (
            "scene/mod.rs",
            "// unsafe to naga:: and crate::gpu\n//! crate::gpu",
        ),
    ];
    for (path, text) in ok {
        assert_eq!(found(path, text), Vec::<String>::new());
    }
    let bad: [(&str, &str); 11] = [
        ("flat/mod.rs", "use crate::features::Features;"),
        ("scene/mod.rs", "use crate::prepared::NONE;"),
        ("reference/world.rs", "let x = crate::gpu::Device::open();"),
        ("reference/mod.rs", "use crate::{prepared::NONE, kernel};"),
        ("prepared/mod.rs", "fn f() { unsafe { g() } }"),
        ("render/mod.rs", "use naga::Module;"),
        ("kernel/mod.rs", "use ash::vk;"),
        ("render/mod.rs", "use crate::kernel::unaudited::compile;"),
        ("render/cpu.rs", "    eprintln!(\"slow\");"),
        ("image/png.rs", "use crate::cli::exit;"),
        ("shelf/mod.rs", "use std::fs;"),
    ];
    for (path, text) in bad {
        assert_eq!(found(path, text).len(), 1, "{path}: {text}");
    }
}
