//! The lines of an OBJ file.

use std::borrow::Cow;
use std::iter;

/// The lines of `text` without their comments, each with its number, from 1; one that ends in `\` is joined to the next.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = (1..).zip(text.split('\n').map(without_comment));
    iter::from_fn(move || {
        let (number, first) = lines.next()?;
        let Some(first) = first.strip_suffix('\\') else {
            return Some((number, first.into()));
        };
        let mut joined = first.to_owned();
        for (_, next) in lines.by_ref() {
            joined.push(' ');
            match next.strip_suffix('\\') {
                Some(next) => joined.push_str(next),
                None => {
                    joined.push_str(next);
                    break;
                }
            }
        }
        Some((number, joined.into()))
    })
}

fn without_comment(line: &str) -> &str {
    line.split('#').next().unwrap_or_default().trim()
}
