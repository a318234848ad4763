//! Lines, words and numbers of text mesh files.

use std::iter;
use std::str::{self, FromStr};

use memchr::memchr2;

use super::MeshError;
use crate::scene::text::quote;

/// The lines of a text. They end in LF, CR LF, or CR alone, as on old Macs.
pub(super) fn lines(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut rest = Some(text);
    iter::from_fn(move || {
        let text = rest.take()?;
        let Some(end) = memchr2(b'\n', b'\r', text) else {
            return Some(text);
        };
        let ending = 1 + usize::from(text[end..].starts_with(b"\r\n"));
        rest = Some(&text[end + ending..]);
        Some(&text[..end])
    })
}

/// An error about line `number` (from 1) of the text `bytes`, which is quoted.
pub(super) fn at_line(bytes: &[u8], number: usize, what: &str) -> MeshError {
    let line = lines(bytes)
        .nth(number.saturating_sub(1))
        .unwrap_or_default();
    let quoted = quote(&String::from_utf8_lossy(line));
    MeshError::Malformed(format!("its line {number} {what}: `{quoted}`"))
}

/// The words of a text, separated by white space.
pub(super) struct Tokens<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Tokens<'a> {
    /// Tokens of a text whose first line has the number `line`.
    pub(super) fn new(text: &'a [u8], line: usize) -> Self {
        Self { rest: text, line }
    }

    /// The line of the last token; before the first token, the first line.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    pub(super) fn bytes_left(&self) -> usize {
        self.rest.len()
    }
}

impl<'a> Iterator for Tokens<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            match self.rest {
                [b'\r', b'\n', rest @ ..] | [b'\n' | b'\r', rest @ ..] => {
                    self.line += 1;
                    self.rest = rest;
                }
                [b' ' | b'\t' | 0x0b | 0x0c, rest @ ..] => self.rest = rest,
                [] => return None,
                rest => {
                    let length = rest.iter().position(|b| matches!(b, b' ' | b'\t'..=b'\r'));
                    let (token, rest) = rest.split_at(length.unwrap_or(rest.len()));
                    self.rest = rest;
                    return Some(token);
                }
            }
        }
    }
}

/// A number as written by C, C++ and Windows: `1.`, `.5`, `nan(ind)`, `1.#QNAN`.
pub(super) fn float<T: FromStr + From<f32>>(token: &[u8]) -> Option<T> {
    let text = str::from_utf8(token).ok()?;
    text.parse().ok().or_else(|| {
        let word = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
        let value = match &*word {
            _ if word.starts_with("nan(") && word.ends_with(')') => f32::NAN,
            // `%f` pads them with zeros.
            word => match word.trim_end_matches('0') {
                "1.#inf" if text.starts_with('-') => f32::NEG_INFINITY,
                "1.#inf" => f32::INFINITY,
                "1.#ind" | "1.#qnan" | "1.#snan" => f32::NAN,
                _ => return None,
            },
        };
        Some(value.into())
    })
}

/// An integer, `3` or `3.0`.
pub(super) fn integer(token: &[u8]) -> Option<i64> {
    let text = str::from_utf8(token).ok()?;
    text.parse().ok().or_else(|| {
        let value: f64 = text.parse().ok()?;
        // Up to this, every integer is exact in a double.
        (value.fract() == 0.0 && value.abs() < 9e15).then_some(value as i64)
    })
}
