//! Numbers as C++ writes and reads them, `.5` and `1.`, which the crate's grammar refuses.

use std::borrow::Cow;

/// The file with a 0 on the bare side of each point that has a digit on the other; its lines keep their numbers. A binary
/// file stays as it is.
pub(super) fn with_digits(file: &[u8]) -> Cow<'_, [u8]> {
    let is_digit = |i: usize| file.get(i).is_some_and(u8::is_ascii_digit);
    let sides = |i: usize| (i > 0 && is_digit(i - 1), is_digit(i + 1));
    let bare = |i: &usize| file[*i] == b'.' && sides(*i).0 != sides(*i).1;
    if !is_ascii(file) || !(0..file.len()).any(|i| bare(&i)) {
        return file.into();
    }
    let mut text = Vec::with_capacity(file.len() + file.len() / 8);
    for (i, byte) in file.iter().enumerate() {
        match (bare(&i), sides(i)) {
            (false, _) => text.push(*byte),
            (true, (true, _)) => text.extend(b".0"),
            (true, (false, _)) => text.extend(b"0."),
        }
    }
    text.into()
}

/// Whether the header says so.
fn is_ascii(file: &[u8]) -> bool {
    let lines = file.split(|b| *b == b'\n').map(<[u8]>::trim_ascii);
    let mut header = lines.take_while(|line| *line != b"end_header");
    header.any(|line| line.starts_with(b"format ascii"))
}
