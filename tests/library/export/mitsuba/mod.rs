//! Scenes in Mitsuba's format: well-formed, each value as computed by hand from the scene; scenes without an equivalent are
//! refused.

mod camera;
mod refusals;
mod shapes;
mod surfaces;

use roxmltree::{Document, Node};
use vkpt::settings::Settings;
use vkpt_cli::export::mitsuba::{Reason, export as mitsuba};
use vkpt_cli::export::{Beside, Remark};

use super::{exported, models_without_an_equal, refusals, same, written};

/// The files of an export: the XML and the meshes.
struct Exported {
    xml: String,
    meshes: Vec<Beside>,
}

fn export_by(text: &str, settings: &Settings) -> Result<Exported, Vec<Remark<Reason>>> {
    let export = exported(text, settings, mitsuba)?;
    Ok(Exported {
        xml: String::from_utf8(written(&export)).expect("UTF-8"),
        meshes: export.beside,
    })
}

fn export(text: &str) -> Exported {
    export_by(text, &Settings::default()).expect("nothing is refused")
}

/// Each refused line and why.
fn refused(text: &str) -> Vec<(usize, Reason)> {
    refusals(export_by(text, &Settings::default()))
}

fn document(exported: &Exported) -> Document<'_> {
    Document::parse(&exported.xml).expect("well-formed XML")
}

/// The plugins of a role, anywhere.
fn plugins<'a>(document: &'a Document, tag: &'static str) -> Vec<Node<'a, 'a>> {
    let all = document.descendants();
    all.filter(|node| node.has_tag_name(tag)).collect()
}

/// The bsdf of a line, without the plugin that makes it two-sided.
fn bsdf<'a>(document: &'a Document, line: usize) -> Node<'a, 'a> {
    let id = format!("bsdf-{line}");
    let all = document.descendants();
    let mut named = all.filter(|node| node.attribute("id") == Some(&id));
    let bsdf = (named.find(|node| node.has_tag_name("bsdf"))).expect("a bsdf of that line");
    match bsdf.attribute("type") {
        Some("twosided") => bsdf.first_element_child().expect("a bsdf in it"),
        _ => bsdf,
    }
}

fn kind<'a>(node: &Node<'a, 'a>) -> &'a str {
    node.attribute("type").expect("a plugin")
}

/// The parameter `name` of a plugin.
fn parameter<'a>(node: &Node<'a, 'a>, name: &str) -> Node<'a, 'a> {
    let found = (node.children()).find(|child| child.attribute("name") == Some(name));
    found.unwrap_or_else(|| panic!("{name} is missing"))
}

fn word<'a>(node: &Node<'a, 'a>, name: &str) -> &'a str {
    let parameter = parameter(node, name);
    parameter.attribute("value").expect("a value")
}

fn numbers(words: &str) -> Vec<f64> {
    let parse = |word: &str| word.parse().expect("a number");
    words.split_whitespace().map(parse).collect()
}

/// The numbers of a parameter are these.
fn check(node: &Node, name: &str, expected: &[f64]) {
    same(&numbers(word(node, name)), expected, name);
}

/// The rows of `to_world` are these.
fn check_matrix(node: &Node, expected: &[f64; 16]) {
    let transform = parameter(node, "to_world");
    let matrix = transform.first_element_child().expect("a matrix");
    let words = matrix.attribute("value").expect("numbers");
    same(&numbers(words), expected, "to_world");
}
