//! How the nearest hit is found: a loop over each kind of shape, a hierarchy, or both.

use super::Subject;
use super::member::shape;
use crate::features::LINEAR_PRIMITIVES;
use crate::prepared::ShapeKind;
use crate::report::explanation::Part;
use crate::report::human::{plural, thousands};

/// The loop and the hierarchy.
pub fn parts(subject: &Subject) -> [Part; 2] {
    let features = &subject.plan.features;
    let looped = features.shapes.difference(&features.in_bvh);
    let looped = counts(subject, looped.copied());
    let within = counts(subject, features.in_bvh.iter().copied());
    // A hierarchy over few is there because all is.
    let few = |kind: &ShapeKind| subject.job.prepared.primitives(*kind) <= LINEAR_PRIMITIVES;
    let many = match features.in_bvh.iter().any(few) {
        true => "--kernel full".to_owned(),
        false => format!("{within}: faster above {LINEAR_PRIMITIVES} of a kind"),
    };
    let absent = match features.shapes.is_empty() {
        true => "there is no shape".to_owned(),
        false => format!("up to {LINEAR_PRIMITIVES} primitives of a kind a loop is faster"),
    };
    [
        part(
            "loops",
            !looped.is_empty(),
            &format!("{looped}: faster up to {LINEAR_PRIMITIVES} of a kind"),
            match within.is_empty() {
                true => "there is no shape",
                false => "all shapes are in the hierarchy",
            },
        ),
        part("hierarchy", !within.is_empty(), &many, &absent),
    ]
}

fn part(name: &str, present: bool, why: &str, absent: &str) -> Part {
    Part {
        group: "search",
        name: name.to_owned(),
        present,
        lines: Vec::new(),
        why: if present { why } else { absent }.to_owned(),
        quote: String::new(),
    }
}

/// `9 spheres, 7 boxes`; nothing of no kind.
fn counts(subject: &Subject, kinds: impl Iterator<Item = ShapeKind>) -> String {
    let prepared = subject.job.prepared;
    let all: Vec<String> = kinds
        .map(|kind| primitives(prepared.primitives(kind), kind))
        .collect();
    all.join(", ")
}

/// `1 sphere`, `7 boxes`, `640 triangles`.
fn primitives(n: usize, kind: ShapeKind) -> String {
    let noun = match kind {
        ShapeKind::Mesh => "triangle",
        other => shape(other),
    };
    let count = thousands(n as u64);
    let text = plural(n as u64, noun).replacen(&n.to_string(), &count, 1);
    text.replace("boxs", "boxes")
}
