//! A scene line by line, as a scene file would have it. Messages and pages refer to these lines as `line N`, because a
//! glTF file has no such lines.

use glam::DVec3;

use crate::scene::text::clean;

/// The lines so far.
#[derive(Default)]
pub(super) struct Listing {
    text: String,
    lines: usize,
}

impl Listing {
    /// Adds a line and its origin; returns its number.
    pub(super) fn add(&mut self, line: &str, of: &str) -> usize {
        let line = match of {
            "" => line.to_owned(),
            of => format!("{line}  # {of}"),
        };
        self.text += &clean(&line).replace('\n', " ");
        self.text.push('\n');
        self.lines += 1;
        self.lines
    }

    pub(super) fn into_text(self) -> String {
        self.text
    }
}

/// Three numbers separated by blanks.
pub(super) fn numbers(v: DVec3) -> String {
    v.to_array().map(number).join(" ")
}

/// A number with all its digits.
pub(super) fn number(x: f64) -> String {
    match x.abs() {
        size if size != 0.0 && !(1e-5..1e9).contains(&size) => format!("{x:e}"),
        _ => x.to_string(),
    }
}
