//! Lines and tokens of a text, with their places.

use super::diagnostic::Place;

/// A run of characters between white space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token<'t> {
    pub text: &'t str,
    pub place: Place,
}

/// The tokens of one line; at least one.
pub(super) type Line<'t> = Vec<Token<'t>>;

/// `text` as read and shown in messages: every line ends in `\n`, without a byte order mark or control characters
/// that a terminal might interpret.
pub(super) fn clean(text: &str) -> String {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    text.replace("\r\n", "\n")
        .chars()
        .map(|c| match c {
            '\r' => '\n',
            '\n' | '\t' => c,
            '\u{b}' | '\u{c}' => ' ',
            c if c.is_control() => char::REPLACEMENT_CHARACTER,
            c => c,
        })
        .collect()
}

/// The lines of a [`clean`] text that contain a command: not blank, not a comment.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut start = 0;
    text.split('\n')
        .enumerate()
        .filter_map(move |(index, line)| {
            let tokens = tokens(line, index + 1, start);
            start += line.len() + 1;
            let first = tokens.first()?;
            (!first.text.starts_with('#')).then_some(tokens)
        })
}

/// The tokens of the line `number`, whose first byte is byte `start` of the text.
fn tokens(line: &str, number: usize, start: usize) -> Line<'_> {
    let (mut counted, mut column) = (0, 1);
    line.split_whitespace()
        .map(|text| {
            let offset = text.as_ptr() as usize - line.as_ptr() as usize;
            column += line[counted..offset].chars().count();
            counted = offset;
            let place = Place {
                line: number,
                column,
                start: start + offset,
                length: text.len(),
            };
            Token { text, place }
        })
        .collect()
}

/// Text of another file for a message: [`clean`], with tabs and line ends replaced, which would break up the message.
pub(super) fn quote(text: &str) -> String {
    shorten(clean(text).replace(['\t', '\n'], " ").trim())
}

/// `text` for a message: all of it, or its beginning if it is long.
pub(super) fn shorten(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
