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

    /// The same with a comment before each file that names it.
    pub fn by_file(&self) -> String {
        let mut text = String::new();
        let mut last = None;
        for (line, &(file, _)) in self.text.lines().zip(&self.lines) {
            if last != Some(file) && file > 0 {
                text += &format!("\n// ──── {} ────\n", heading(&self.files[file]));
            }
            last = Some(file);
            text += line;
            text.push('\n');
        }
        text
    }

    /// The parts of the kernel, in order: files, `<slot>`s filled with text, `<prelude>`.
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

/// A file's path in the repository, or the purpose of a text that was generated for the scene.
fn heading(name: &str) -> String {
    match name {
        "<prelude>" => "constants, structs and buffers of the scene".to_owned(),
        slot if slot.starts_with('<') => format!("{slot}: made for the scene"),
        constants if constants.starts_with("constants/") => {
            format!("{constants}: shared with the host")
        }
        root if root.ends_with(".comp") => format!("shaders/{root}"),
        file => format!("shaders/{file}.glsl"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::{Composer, compile};

    #[test]
    fn headings_are_comments_and_change_no_module() {
        let kernel = Composer::new()
            .compose(&["probe/loop_limit.comp"])
            .expect("a kernel");
        let text = kernel.by_file();
        let heading = "\n// ──── shaders/probe/loop_limit.comp ────\n";
        assert_eq!(text.replacen(heading, "", 1), kernel.text());
        let mut again = Composed::new();
        again.append("all", text.trim_start_matches("#version 450\n"));
        assert_eq!(compile(&again), compile(&kernel));
    }
}
