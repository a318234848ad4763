//! A composed kernel and the way back from its lines to the files.

use super::error::Culprit;

/// The GLSL text of one kernel.
#[derive(Clone, Debug)]
pub struct Composed {
    text: String,
    /// For each line of `text`, where it comes from.
    lines: Vec<(usize, usize)>,
    files: Vec<String>,
}

/// A line of a shader file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place<'a> {
    pub file: &'a str,
    /// From 1.
    pub line: usize,
    pub text: &'a str,
}

impl Composed {
    pub(super) fn new() -> Self {
        let mut composed = Self {
            text: String::new(),
            lines: Vec::new(),
            files: Vec::new(),
        };
        composed.append("<version>", "#version 450\n");
        composed
    }

    /// Appends a file's text and enters its lines in the table.
    pub(super) fn append(&mut self, file: &str, text: &str) {
        for (i, line) in text.lines().enumerate() {
            self.text.push_str(line);
            self.text.push('\n');
            self.lines.push((self.files.len(), i + 1));
        }
        self.files.push(file.to_owned());
    }

    /// The whole text, from `#version` on.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What the kernel is made of, in order: files, `<slot>`s filled with text, `<prelude>`.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.files.iter().skip(1).map(String::as_str)
    }

    /// Where the byte at `offset` of the text comes from.
    pub fn place(&self, offset: usize) -> Place<'_> {
        let bytes = self.text.as_bytes();
        let before = &bytes[..offset.min(bytes.len())];
        let row = before
            .iter()
            .filter(|b| **b == b'\n')
            .count()
            .min(self.lines.len() - 1);
        let (file, line) = self.lines[row];
        Place {
            file: &self.files[file],
            line,
            text: self.text.lines().nth(row).unwrap_or_default(),
        }
    }

    pub(super) fn culprit(&self, offset: usize, message: impl Into<String>) -> Culprit {
        let Place { file, line, text } = self.place(offset);
        Culprit {
            message: message.into(),
            file: file.to_owned(),
            line,
            text: text.to_owned(),
        }
    }
}
