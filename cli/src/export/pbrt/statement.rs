//! Statements of pbrt's format: a directive, its words, and parameters of the form `"type name" [ values ]`.

use std::fmt::Write;

use glam::{DMat4, DVec3};

/// Range of wavelengths in nm that covers all visible light.
const VISIBLE: [f64; 2] = [360.0, 830.0];

/// A statement, on its own line.
#[derive(Clone, Debug)]
pub struct Statement(String);

impl Statement {
    pub fn new(directive: &str) -> Self {
        Self(directive.to_owned())
    }

    /// A quoted word: the name of a plugin, a material, a medium.
    pub fn word(mut self, word: &str) -> Self {
        self.0.push(' ');
        self.0.push_str(&quoted(word));
        self
    }

    /// p' = `matrix` · p, column by column.
    pub fn matrix(self, matrix: DMat4) -> Self {
        self.values(&matrix.to_cols_array())
    }

    fn values<T: ToString>(mut self, values: &[T]) -> Self {
        let values: Vec<String> = values.iter().map(T::to_string).collect();
        // Writing to a String cannot fail.
        let _ = write!(self.0, " [ {} ]", values.join(" "));
        self
    }

    fn parameter<T: ToString>(self, kind: &str, name: &str, values: &[T]) -> Self {
        self.word(&format!("{kind} {name}")).values(values)
    }

    pub fn float(self, name: &str, value: f64) -> Self {
        self.parameter("float", name, &[value])
    }

    pub fn integer(self, name: &str, value: u32) -> Self {
        self.integers(name, &[value])
    }

    pub fn integers(self, name: &str, values: &[u32]) -> Self {
        self.parameter("integer", name, values)
    }

    pub fn boolean(self, name: &str, value: bool) -> Self {
        self.parameter("bool", name, &[value])
    }

    pub fn string(self, name: &str, value: &str) -> Self {
        self.parameter("string", name, &[quoted(value)])
    }

    /// Linear RGB with sRGB's primaries, which pbrt converts to a spectrum.
    pub fn rgb(self, name: &str, value: DVec3) -> Self {
        self.parameter("rgb", name, &value.to_array())
    }

    /// The same value at every wavelength.
    pub fn flat(self, name: &str, value: f64) -> Self {
        let [from, to] = VISIBLE;
        self.parameter("spectrum", name, &[from, value, to, value])
    }

    pub fn points(self, name: &str, points: &[DVec3]) -> Self {
        let values: Vec<f64> = points.iter().flat_map(|p| p.to_array()).collect();
        self.parameter("point3", name, &values)
    }
}

/// The file with these statements.
pub fn text(statements: &[Statement]) -> String {
    let lines = statements.iter().map(|statement| &*statement.0);
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// Quotes a word, with pbrt's backslash escapes.
fn quoted(word: &str) -> String {
    let mut quoted = String::from('"');
    for letter in word.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            _ => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}
