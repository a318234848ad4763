//! Functions and their arguments, read from the text of both languages.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::common::files::below;
use crate::common::root;

/// A function's head.
#[derive(Clone, Debug)]
pub struct Function {
    /// Below `shaders/` or `src/reference/`, without ending; `a/mod.rs` counts as `a`.
    pub file: String,
    pub name: String,
    /// Names of the arguments that count, without the underscore of an unused one.
    pub arguments: Vec<String>,
    /// Of a Rust type.
    pub method: bool,
}

impl fmt::Display for Function {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "{}: {}({})",
            self.file,
            self.name,
            self.arguments.join(", ")
        )
    }
}

/// Types of arguments that represent a kernel's slots, buffers and push constants, or that record.
const GIVEN_TO_RUST: [&str; 18] = [
    "&Settings",
    "&World<F>",
    "&Primitives<F>",
    "&impl Cover<F>",
    "&mut impl Recorder<F>",
    "&impl Weigh<F>",
    "Transport<F>",
    "&[Aim<F>]",
    "&mut LightCounts",
    "SampleId",
    "Origin",
    "Window",
    "Absorption",
    "Connect",
    "Roulette",
    "Sampler",
    "&[",
    "Option<&[",
];
/// Where a kernel keeps its counts, and the number of the pixel, which Rust has in a `SampleId`.
const GIVEN_TO_KERNELS: [&str; 4] = [
    "inout FilmPixel pixel",
    "inout LightLane lane",
    "inout LightState s",
    "uint pixel_index",
];

/// The functions that a GLSL text defines: each head starts its line and ends it with a brace.
pub fn glsl_functions(file: &str, text: &str) -> Vec<Function> {
    let code = without_comments(text);
    let heads = code.split('\n').scan(0, |at, line| {
        let start = *at;
        *at += line.len() + 1;
        Some((start, line))
    });
    let head = |(start, line): (usize, &str)| {
        let (ty, name) = line.split_once('(')?.0.split_once(' ')?;
        let (inside, rest) = parentheses(&code[start + line.find('(')?..])?;
        let defined = is_word(ty) && is_word(name) && rest.trim_start().starts_with('{');
        defined.then(|| Function {
            file: file.to_owned(),
            name: name.to_owned(),
            arguments: split(inside)
                .filter(|a| name == "film_sample" || !GIVEN_TO_KERNELS.contains(a))
                .filter_map(|a| a.split(' ').next_back().map(str::to_owned))
                .collect(),
            method: false,
        })
    };
    heads.filter_map(head).collect()
}

/// All functions of `src/reference/`, except those of tests.
pub fn rust_functions() -> Vec<Function> {
    let root = root().join("src/reference");
    let mut all = Vec::new();
    for (path, text) in sources(&root) {
        let name = path.strip_prefix(&root).expect("below the root");
        let name = name.with_extension("").to_string_lossy().into_owned();
        let file = name.strip_suffix("/mod").unwrap_or(&name);
        all.extend(functions_of(file, &text));
    }
    all
}

/// The Rust files below a folder with their texts, without tests.
pub fn sources(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut files = below(folder, &|folder| !folder.ends_with("tests"));
    files.retain(|path| !path.ends_with("tests.rs"));
    let text = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a file");
        let code = text.split("#[cfg(test)]\nmod tests {").next();
        let code = code.unwrap_or_default().to_owned();
        (path, code)
    };
    files.into_iter().map(text).collect()
}

fn functions_of(file: &str, text: &str) -> Vec<Function> {
    let code = without_comments(text);
    let mut all = Vec::new();
    for (at, _) in code.match_indices("fn ") {
        let line = code[..at].rsplit('\n').next().unwrap_or_default();
        let name: String = code[at + 3..]
            .chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect();
        let before = line.trim_start();
        let Some(open) = code[at..].find('(') else {
            continue;
        };
        // `fn` in a bound or in `pub(crate)` text is no head
        if name.is_empty() || !["", "pub ", "pub(super) ", "pub(crate) "].contains(&before) {
            continue;
        }
        let Some((inside, _)) = parentheses(&code[at + open..]) else {
            continue;
        };
        all.push(Function {
            file: file.to_owned(),
            name,
            arguments: split(inside).filter_map(rust_argument).collect(),
            method: line.starts_with(' '),
        });
    }
    all
}

/// The name of an argument that counts.
fn rust_argument(text: &str) -> Option<String> {
    let (name, ty) = text.split_once(':')?;
    let given = GIVEN_TO_RUST.iter().any(|t| ty.trim().starts_with(t));
    let name = name
        .trim()
        .trim_start_matches("mut ")
        .trim_start_matches('_');
    (!given).then(|| name.to_owned())
}

fn is_word(w: &str) -> bool {
    !w.is_empty() && w.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

fn without_comments(text: &str) -> String {
    let code = |line: &str| {
        line.split("//")
            .next()
            .unwrap_or_default()
            .trim_end()
            .to_owned()
    };
    text.lines().map(code).collect::<Vec<_>>().join("\n")
}

/// The text between the first parenthesis and the one that closes it, and the text after it.
fn parentheses(text: &str) -> Option<(&str, &str)> {
    let mut depth = 0;
    for (i, c) in text.char_indices() {
        depth += match c {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        if depth == 0 {
            return Some((&text[1..i], &text[i + 1..]));
        }
    }
    None
}

/// The parts between commas outside all brackets.
fn split(text: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0;
    let outside = move |c: char| {
        depth += match c {
            '(' | '[' | '<' => 1,
            ')' | ']' | '>' => -1,
            _ => 0,
        };
        c == ',' && depth == 0
    };
    text.split(outside).map(str::trim).filter(|a| !a.is_empty())
}

/// Public functions without a comment above them, attributes aside.
pub fn undocumented(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().map(str::trim_start).collect();
    let heads = lines
        .iter()
        .enumerate()
        .filter(|(_, l)| l.starts_with("pub fn "));
    let bare = heads.filter(|(i, _)| {
        let above = lines[..*i].iter().rev().find(|l| !l.starts_with("#["));
        above.is_none_or(|l| !l.starts_with("///"))
    });
    bare.map(|(_, line)| (*line).to_owned()).collect()
}

#[test]
fn bare_functions_are_found() {
    let text =
        "/// One.\n#[inline]\npub fn one() {}\n\n// Two.\npub fn two() {}\n    pub fn three() {}\n";
    assert_eq!(undocumented(text), ["pub fn two() {}", "pub fn three() {}"]);
}

#[test]
fn heads_are_read() {
    let glsl = "// float no(int a) {\nfloat one(vec3 p,\n          inout uint q) {\n    return two(p);\n}\n";
    let found: Vec<String> = glsl_functions("f", glsl)
        .iter()
        .map(Function::to_string)
        .collect();
    assert_eq!(found, ["f: one(p, q)"]);
    let rust = "/// fn no(a: u32)\npub fn one<F: Real>(_s: &Settings, mut p: Vec3<F>, _u: [F; 2]) -> F {\n    p\n}\n\
                impl A {\n    fn two(&self, x: u32) {}\n}\n";
    let found = functions_of("f", rust);
    let names: Vec<String> = found.iter().map(Function::to_string).collect();
    assert_eq!(names, ["f: one(p, u)", "f: two(x)"]);
    assert_eq!((found[0].method, found[1].method), (false, true));
}
