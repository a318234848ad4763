//! Every link of every Markdown page leads to a file or folder of this repository, and its anchor to a heading there. Links to
//! other sites are by https and are not followed. Pages that sources name by their path exist.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::common::files::below;

/// Where pages are that this repository does not keep.
const SKIPPED: [&str; 3] = ["target", "node_modules", "test-results"];

/// Folders whose sources name pages by their path, and the endings of such sources.
const FOLDERS: [&str; 9] = [
    "benches", "cli", "examples", "lab", "python", "scripts", "shaders", "src", "tests",
];
const ENDINGS: [&str; 7] = ["rs", "glsl", "comp", "py", "pyi", "txt", ""];

/// Whether a folder is one that this repository keeps.
fn is_kept(folder: &Path) -> bool {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    !name.starts_with('.') && !SKIPPED.contains(&&*name)
}

fn ending(path: &Path) -> &str {
    path.extension().and_then(|e| e.to_str()).unwrap_or("")
}

/// The lines of a page that are text, with empty lines in place of blocks of code.
fn prose(page: &str) -> Vec<String> {
    let mut fenced = false;
    let lines = page.lines().map(|line| {
        let fence = line.trim_start().starts_with("```");
        fenced ^= fence;
        match fenced || fence {
            true => String::new(),
            false => line.to_owned(),
        }
    });
    lines.collect()
}

/// The text without the parts between backticks: they contain no link.
fn without_code(text: &str) -> String {
    let mut spoken = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('`') {
        spoken += before;
        let ticks = 1 + after.len() - after.trim_start_matches('`').len();
        let after = &after[ticks - 1..];
        match after.split_once(&"`".repeat(ticks)) {
            Some((_, after)) => rest = after,
            None => rest = after,
        }
    }
    spoken + rest
}

/// Where the links and pictures of a page lead to.
fn links(page: &str) -> Vec<String> {
    let text = without_code(&prose(page).join("\n"));
    let mut links = Vec::new();
    for (at, _) in text.match_indices("](") {
        let target = text[at + 2..].split([')', '\n']).next().unwrap_or_default();
        links.push(target.split(' ').next().unwrap_or_default().to_owned());
    }
    for (at, _) in text.match_indices('<') {
        let target = text[at + 1..].split('>').next().unwrap_or_default();
        if target.contains("://") {
            links.push(target.to_owned());
        }
    }
    // [name]: target
    for line in text.lines().filter(|line| line.starts_with('[')) {
        if let Some((_, target)) = line.split_once("]: ") {
            links.push(target.to_owned());
        }
    }
    links
}

/// The anchors of a page's headings, as GitHub makes them: letters and digits in lower case, `-` and `_`, a `-` for each blank,
/// without all other characters; a repeated one gets a number.
fn anchors(page: &str) -> BTreeSet<String> {
    let mut taken: BTreeMap<String, usize> = BTreeMap::new();
    let mut anchors = BTreeSet::new();
    for line in prose(page) {
        let title = line.trim_start_matches('#');
        let depth = line.len() - title.len();
        if !(1..=6).contains(&depth) || !title.starts_with(' ') {
            continue;
        }
        let slug = slug(title.trim());
        let times = taken.entry(slug.clone()).or_default();
        anchors.insert(match *times {
            0 => slug,
            n => format!("{slug}-{n}"),
        });
        *times += 1;
    }
    anchors
}

fn slug(title: &str) -> String {
    // Of a link its text is shown.
    let mut shown = String::new();
    let mut rest = title;
    while let Some((before, after)) = rest.split_once("](") {
        shown += before;
        rest = after.split_once(')').map_or("", |(_, after)| after);
    }
    shown += rest;
    let lower = shown.to_lowercase();
    let kept = lower.chars().filter_map(|c| match c {
        ' ' => Some('-'),
        '-' | '_' => Some(c),
        c if c.is_alphanumeric() => Some(c),
        _ => None,
    });
    kept.collect()
}

/// A path without `.` and `..`, none where it leads out of the repository.
fn resolved(path: &Path) -> Option<PathBuf> {
    let mut resolved = PathBuf::new();
    for component in path.components() {
        match component {
            Component::Normal(name) => resolved.push(name),
            Component::ParentDir if !resolved.pop() => return None,
            Component::ParentDir | Component::CurDir => {}
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    Some(resolved)
}

/// The error of a link of the page at `from`.
fn wrong(root: &Path, from: &Path, link: &str) -> Option<String> {
    if link.contains("://") || link.starts_with("mailto:") {
        return (!link.starts_with("https://")).then(|| format!("{link}: not by https"));
    }
    let (path, anchor) = match link.split_once('#') {
        Some((path, anchor)) => (path, Some(anchor)),
        None => (link, None),
    };
    let at = match path {
        "" => Some(from.to_owned()),
        path => resolved(&from.parent().expect("a folder").join(path)),
    };
    let Some(at) = at else {
        return Some(format!("{link}: leads out of the repository"));
    };
    let at = root.join(at);
    if !at.exists() || (path.ends_with('/') && !at.is_dir()) {
        return Some(format!("{link}: nothing is there"));
    }
    let anchor = anchor?;
    let has_anchor =
        ending(&at) == "md" && anchors(&fs::read_to_string(&at).expect("a page")).contains(anchor);
    (!has_anchor).then(|| format!("{link}: no such heading"))
}

/// How many links the pages below `root` have, and which are wrong.
fn complaints(root: &Path) -> (usize, Vec<String>) {
    let mut pages = below(root, &is_kept);
    pages.retain(|path| ending(path) == "md");
    let (mut count, mut complaints) = (0, Vec::new());
    for file in pages {
        let page = fs::read_to_string(&file).expect("a page");
        let path = file.strip_prefix(root).expect("a page below the root");
        let links = links(&page);
        count += links.len();
        let wrong = links.iter().filter_map(|link| wrong(root, path, link));
        complaints.extend(wrong.map(|wrong| format!("{}: {wrong}", path.display())));
    }
    (count, complaints)
}

/// The pages below `docs/` that a text names.
fn named(text: &str) -> Vec<&str> {
    let places = text.match_indices("docs/");
    let paths = places.map(|(at, _)| {
        let rest = &text[at..];
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && !"-_./".contains(c));
        &rest[..end.unwrap_or(rest.len())]
    });
    let paths = paths.map(|path| path.trim_end_matches('.'));
    paths.filter(|path| path.ends_with(".md")).collect()
}

#[test]
fn links_lead_somewhere() {
    let (count, complaints) = complaints(Path::new("."));
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    assert!(count > 150, "only {count} links were found");
}

#[test]
fn pages_that_sources_name_exist() {
    let (mut count, mut missing) = (0, Vec::new());
    for folder in FOLDERS {
        let mut sources = below(Path::new(folder), &is_kept);
        sources.retain(|path| ENDINGS.contains(&ending(path)) && !path.ends_with("links.rs"));
        for path in sources {
            let text = fs::read(&path).expect("a source file");
            let text = String::from_utf8_lossy(&text);
            for page in named(&text) {
                count += 1;
                if !Path::new(page).exists() {
                    missing.push(format!("{}: {page}", path.display()));
                }
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
    assert!(count > 30, "only {count} pages are named");
}

/// Pages with one right link of each kind, and one more.
fn planted(link: &str) -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    let root = folder.path();
    fs::create_dir_all(root.join("docs/data")).expect("a folder");
    fs::create_dir_all(root.join("target")).expect("a folder");
    let pages = [
        ("target/built.md", "[x](nowhere.md)"),
        ("docs/data/a.txt", ""),
        (
            "docs/page.md",
            "# The page\n## Kd, Ks & `--vary`: *what* it's for\n```sh\n## no heading\n```\n## Twice\n## Twice\n### [α_p](page.md) – 2\n",
        ),
    ];
    for (path, text) in pages {
        fs::write(root.join(path), text).expect("a page");
    }
    let page = format!(
        "# A\n[a](docs/page.md) ![b](docs/data/a.txt) [c](docs) [d](docs/data/) [e](#a) <https://example.org/x>\n\
         [f](docs/page.md#kd-ks----vary-what-its-for) [g](docs/page.md#twice-1) [h](docs/page.md#α_p--2)\n\
         `[code](nowhere.md)` and ``[`code`](nowhere.md)``\n```\n[block](nowhere.md)\n```\n{link}\n"
    );
    fs::write(root.join("README.md"), page).expect("a page");
    let (count, complaints) = complaints(root);
    assert!(count >= 9, "{count}");
    complaints
}

#[test]
fn planted_errors_are_found() {
    assert_eq!(planted(""), Vec::<String>::new());
    for link in [
        "[x](nowhere.md)",
        "![x](docs/nowhere.png)",
        "[x](docs/page.md/)",
        "[x](Docs/page.md)",
        "[x](../outside.md)",
        "[x](/docs/page.md)",
        "[x](#b)",
        "[x](docs/page.md#Twice)",
        "[x](docs/page.md#twice-2)",
        "[x](docs/page.md#no-heading)",
        "[x](docs/data/a.txt#a)",
        "[x](docs#a)",
        "[x](http://example.org)",
        "<http://example.org>",
        "[x]: nowhere.md",
    ] {
        let found = planted(link);
        assert_eq!(found.len(), 1, "{link}: {found:?}");
        assert!(found[0].starts_with("README.md: "), "{link}: {found:?}");
    }
    assert_eq!(
        named("see docs/a.md, docs/b/c.md."),
        ["docs/a.md", "docs/b/c.md"]
    );
    assert!(named("docs/ and docs/a.png").is_empty());
}
