//! Circles of files that need one another.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path as Folder;

use super::source::{Path, Source};

/// Which of the modules each needs; a child that a `use` begins with counts too.
fn needs(sources: &[Source]) -> BTreeMap<Path, BTreeSet<Path>> {
    let modules: BTreeSet<Path> = sources.iter().map(Source::module).collect();
    let innermost = |path: Path| {
        let mut path = path;
        while path.len() > 0 && !modules.contains(&path) {
            path = path.above();
        }
        (path.len() > 0).then_some(path)
    };
    let of = |source: &Source| {
        let own = source.module();
        let children = source.lines().filter_map(|(_, code)| {
            let used = code.trim_start_matches("pub ").strip_prefix("use ")?;
            let (name, _) = used.split_once("::")?;
            Some(own.clone().join(&[name])).filter(|child| modules.contains(child))
        });
        let named = source
            .names()
            .into_iter()
            .filter_map(|(_, path)| innermost(path));
        let all = children.chain(named).filter(|other| *other != own);
        (own.clone(), all.collect())
    };
    sources.iter().map(of).collect()
}

/// Modules each of which needs itself, through others.
fn in_circles(sources: &[Source]) -> Vec<String> {
    let needs = needs(sources);
    let reached = |start: &Path| {
        let mut reached = BTreeSet::new();
        let mut open: Vec<&Path> = vec![start];
        while let Some(next) = open.pop() {
            let new = needs[next]
                .iter()
                .filter(|other| reached.insert((*other).clone()));
            open.extend(new);
        }
        reached
    };
    let circular = needs
        .keys()
        .filter(|module| reached(module).contains(module));
    circular.map(ToString::to_string).collect()
}

/// Whether a file belongs to the command line: to a command, or to the parts that commands share.
fn is_of_command_line(source: &Source) -> bool {
    let path = source.path.as_str();
    let others = ["cli/export/", "cli/farm/", "cli/live/"];
    let is_command = path.contains("/command/") || path.ends_with("/command.rs");
    is_command
        || path.starts_with("lab/cli/")
        || path.starts_with("cli/") && !others.iter().any(|room| path.starts_with(room))
}

#[test]
fn no_two_files_of_the_command_line_need_each_other() {
    let all = ["lab/src", "cli/src"].map(|folder| Source::all(Folder::new(folder)));
    let sources: Vec<_> = all
        .into_iter()
        .flatten()
        .filter(is_of_command_line)
        .collect();
    assert!(sources.len() > 80);
    let circular = in_circles(&sources);
    assert!(
        circular.is_empty(),
        "these files need one another: {}",
        circular.join(", ")
    );
}

#[test]
fn a_planted_circle_is_found() {
    let found = |files: &[(&str, &str)]| {
        let sources: Vec<_> = files
            .iter()
            .map(|(path, text)| Source::new(path, text))
            .collect();
        in_circles(&sources)
    };
    let straight = [
        ("lab/cli/mod.rs", "mod a; pub use a::x;"),
        (
            "lab/cli/a.rs",
            "use super::b::{self, y}; use crate::render::Job;",
        ),
        (
            "lab/cli/b.rs",
            "#[cfg(test)]\nmod tests {\n    use super::*;\n}",
        ),
    ];
    assert!(found(&straight).is_empty(), "{:?}", found(&straight));
    let circle = [
        straight[0],
        straight[1],
        ("lab/cli/b.rs", "use crate::cli::c;"),
        ("lab/cli/c.rs", "use super::a;"),
    ];
    assert_eq!(
        found(&circle),
        ["lab::cli::a", "lab::cli::b", "lab::cli::c"]
    );
    let family = [
        ("lab/cli/mod.rs", "mod a;\npub use a::x;"),
        ("lab/cli/a.rs", "use super::z;"),
    ];
    assert_eq!(found(&family), ["lab::cli", "lab::cli::a"]);
}
