//! How the nearest hit is found: primitives tried one by one, a hierarchy, or both.

use super::Subject;
use crate::explain::report::Part;
use vkpt::features::WRITTEN_OUT;
use vkpt::prepared::ShapeKind;
use vkpt::render::KernelChoice;
use vkpt::report::human::thousands;

/// One by one, and the hierarchy.
pub fn parts(subject: &Subject) -> [Part; 2] {
    let features = &subject.plan.features;
    let tried = counts(subject, features.written_out());
    let within = counts(subject, features.in_bvh.iter().copied());
    let many = match subject.job.kernel {
        KernelChoice::Full => "--kernel full".to_owned(),
        _ => format!("{within}: faster above {WRITTEN_OUT} in all"),
    };
    let absent = match features.shapes.is_empty() {
        true => "the scene has no shapes".to_owned(),
        false => format!("up to {WRITTEN_OUT} primitives are faster one by one"),
    };
    [
        part(
            "one by one",
            !tried.is_empty(),
            &format!("{tried}: faster up to {WRITTEN_OUT} in all"),
            match within.is_empty() {
                true => "the scene has no shapes",
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

/// `9 spheres, 7 boxes`; empty for no kinds.
fn counts(subject: &Subject, kinds: impl Iterator<Item = ShapeKind>) -> String {
    let prepared = subject.job.prepared;
    let all: Vec<String> = kinds
        .map(|kind| primitives(prepared.primitives.count(kind), kind))
        .collect();
    all.join(", ")
}

/// `1 sphere`, `7 boxes`, `640 triangles`.
fn primitives(n: usize, kind: ShapeKind) -> String {
    let [one, several] = kind.description().primitives;
    format!(
        "{} {}",
        thousands(n as u64),
        if n == 1 { one } else { several }
    )
}
