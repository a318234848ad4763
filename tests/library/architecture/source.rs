//! Source files, and the modules and items that they name.

use std::fmt;
use std::path;

use crate::common::files;

/// A path from the crate's root: of a module, or of an item in it.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Path(Vec<String>);

impl Path {
    /// Whether it is `other` or below it.
    pub fn is_within(&self, other: &Self) -> bool {
        self.0.starts_with(&other.0)
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Without its last name; the root is above itself.
    pub fn above(mut self) -> Self {
        self.0.pop();
        self
    }

    pub fn join(mut self, names: &[&str]) -> Self {
        self.0.extend(names.iter().map(|&name| name.to_owned()));
        self
    }
}

impl<'a> FromIterator<&'a str> for Path {
    fn from_iter<I: IntoIterator<Item = &'a str>>(names: I) -> Self {
        Self(names.into_iter().map(str::to_owned).collect())
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0.join("::"))
    }
}

/// The folders of the crates' sources: that of vkpt, then those of the others, each below its own name.
pub const FOLDERS: [&str; 3] = ["src", "lab/src", "cli/src"];

/// The crates other than vkpt.
const MEMBERS: [&str; 2] = ["lab", "cli"];

/// A source file of one of the crates.
pub struct Source {
    /// Without `src/`, as `scene/mod.rs` and `lab/check/mod.rs`.
    pub path: String,
    /// Without comments.
    code: String,
}

impl Source {
    pub fn new(path: &str, text: &str) -> Self {
        let code = |line: &'_ str| line.split("//").next().unwrap_or_default().to_owned();
        Self {
            path: path.to_owned(),
            code: text.lines().map(code).collect::<Vec<_>>().join("\n"),
        }
    }

    /// All files below a folder of [`FOLDERS`], or of one of these.
    pub fn all(folder: &path::Path) -> Vec<Self> {
        let mut files = files::below(folder, &|_| true);
        files.retain(|path| path.extension().is_some_and(|e| e == "rs"));
        let source = |path: path::PathBuf| {
            let text = std::fs::read_to_string(&path).expect("a text");
            let path = path.to_string_lossy().replace('\\', "/");
            Self::new(&path.replacen("src/", "", 1), &text)
        };
        files.into_iter().map(source).collect()
    }

    /// The module that the file is.
    pub fn module(&self) -> Path {
        let name = self.path.trim_end_matches(".rs");
        let name = name.strip_suffix("/mod").unwrap_or(name);
        name.split('/').collect()
    }

    /// Lines of code with their numbers.
    pub fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        (1..).zip(self.code.lines())
    }

    /// The root of its crate: `lab`, `cli`, or nothing for vkpt.
    fn root(&self) -> Path {
        let first = self.path.split('/').take(1);
        first.filter(|name| MEMBERS.contains(name)).collect()
    }

    /// All paths that begin with `crate::`, `super::`, `self::` or the name of a crate of vkpt's, with the number of their line; a
    /// `use` of several names is as many paths.
    pub fn names(&self) -> Vec<(usize, Path)> {
        // A file ends with the module of its tests, if it has one.
        let tests = self.code.find("mod tests {").unwrap_or(usize::MAX);
        let (mut all, mut read) = (Vec::new(), 0);
        for (start, _) in self.code.match_indices("::") {
            if start < read {
                continue;
            }
            let module = match start < tests {
                true => self.module(),
                false => self.module().join(&["tests"]),
            };
            let before = &self.code[..start];
            let word = before.rfind(|c: char| !is_of_name(c)).map_or(0, |i| i + 1);
            let base = match &before[word..] {
                "crate" => self.root(),
                "vkpt" => Path(Vec::new()),
                "vkpt_lab" => ["lab"].into_iter().collect(),
                "vkpt_cli" => ["cli"].into_iter().collect(),
                "self" => module,
                "super" if !before[..word].ends_with("::") => module.above(),
                _ => continue,
            };
            let line = 1 + before.matches('\n').count();
            let mut paths = Vec::new();
            let rest = branches(&self.code[start + 2..], &[], &mut paths);
            read = self.code.len() - rest.len();
            all.extend(paths.iter().map(|names| (line, below(&base, names))));
        }
        all
    }
}

/// `names` from `base` on, where each leading `super` leads up.
fn below(base: &Path, names: &[&str]) -> Path {
    match names {
        ["super", rest @ ..] => below(&base.clone().above(), rest),
        ["self", rest @ ..] => below(base, rest),
        _ => base.clone().join(names),
    }
}

/// Adds the paths of the use tree at the start of `text`, each after `prefix`; returns the text after the tree.
fn branches<'t>(text: &'t str, prefix: &[&'t str], all: &mut Vec<Vec<&'t str>>) -> &'t str {
    let text = text.trim_start();
    if let Some(mut rest) = text.strip_prefix('{') {
        loop {
            // After a branch: `as` another name, a comma, or the end.
            rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
            match rest.strip_prefix('}') {
                Some(after) => return after,
                None if rest.is_empty() => return rest,
                None => rest = branches(rest, prefix, all),
            }
            rest = &rest[rest.find([',', '}']).unwrap_or(rest.len())..];
        }
    }
    let (name, rest) = text.split_at(text.find(|c| !is_of_name(c)).unwrap_or(text.len()));
    let path = [prefix, &[name]].concat();
    match rest.strip_prefix("::") {
        Some(more) if more.starts_with(|c| is_of_name(c) || c == '{') => branches(more, &path, all),
        _ => {
            // `self` in braces, and `*`, are all that is before them.
            let whole = matches!(name, "" | "self");
            all.push(if whole { prefix.to_vec() } else { path });
            rest
        }
    }
}

fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

#[test]
fn every_way_to_name_a_module_is_seen() {
    let named = |text: &str| {
        let source = Source::new("render/vulkan/run.rs", text);
        let names = source.names().into_iter();
        names
            .map(|(line, path)| format!("{line} {path}"))
            .collect::<Vec<_>>()
    };
    let rows: [(&str, &[&str]); 9] = [
        (
            "use crate::a;\nlet x = crate::b::C::new();",
            &["1 a", "2 b::C::new"],
        ),
        (
            "use crate::{a::{self, B as _}, c::*, d};",
            &["1 a", "1 a::B", "1 c", "1 d"],
        ),
        (
            "use crate::a::{\n    b,\n    c::{D, E},\n};",
            &["1 a::b", "1 a::c::D", "1 a::c::E"],
        ),
        ("use super::a::b;", &["1 render::vulkan::a::b"]),
        ("use super::super::super::gpu::Device;", &["1 gpu::Device"]),
        (
            "use super::{super::a, b};",
            &["1 render::a", "1 render::vulkan::b"],
        ),
        ("use self::a;", &["1 render::vulkan::run::a"]),
        (
            "mod tests {\n    use super::*;\n    use crate::a;\n}",
            &["2 render::vulkan::run", "3 a"],
        ),
        (
            "// use crate::a;\nmy_crate::b(); self.c(); crate::d::<T>()",
            &["2 d"],
        ),
    ];
    for (text, expected) in rows {
        assert_eq!(named(text), expected, "{text}");
    }
}
