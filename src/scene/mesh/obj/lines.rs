//! The logical lines of an OBJ file.

use std::borrow::Cow;
use std::iter;

use memchr::memchr_iter;

use crate::scene::mesh::text::lines;

/// The lines of `text` without comments, each with its number, from 1; a line that ends in `\` is joined with the next.
/// Only comments and names may contain bytes that are not UTF-8.
pub(super) fn statements(text: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = (1..).zip(lines(text).map(without_comment));
    iter::from_fn(move || {
        let (number, first) = lines.next()?;
        // A name may end in a back slash, as folder names do.
        let Some(first_part) = first.strip_suffix('\\').filter(|line| !is_name(line)) else {
            return Some((number, first));
        };
        let mut joined = first_part.to_owned();
        for (_, next) in lines.by_ref() {
            joined.push(' ');
            match next.strip_suffix('\\') {
                Some(next) => joined.push_str(next),
                None => {
                    joined.push_str(&next);
                    break;
                }
            }
        }
        Some((number, joined.into()))
    })
}

/// Whether a statement gives a name rather than numbers.
fn is_name(statement: &str) -> bool {
    let word = statement.split_whitespace().next();
    word.is_some_and(|word| ["o", "g", "usemtl", "mtllib", "usemap", "maplib"].contains(&word))
}

fn without_comment(line: &[u8]) -> Cow<'_, str> {
    let mut signs = memchr_iter(b'#', line);
    let end = signs.find(|&i| !is_in_a_number(line, i));
    let statement = &line[..end.unwrap_or(line.len())];
    String::from_utf8_lossy(statement.trim_ascii())
}

/// Windows writes NaN and infinity as `1.#QNAN`, `1.#IND` and `1.#INF`.
fn is_in_a_number(line: &[u8], i: usize) -> bool {
    let (before, behind) = (&line[..i], &line[i + 1..]);
    let words = [&b"QNAN"[..], b"SNAN", b"IND", b"INF"];
    before.ends_with(b"1.") && words.iter().any(|word| behind.starts_with(word))
}
