//! What a user writes, as a regular expression over the letters of paths.

use super::Letter;

/// A pattern that is none, and why.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{text:?} is no class of paths, {why}: E, the eye, comes first, then D (diffuse), G (rough) or S (smooth) for each surface, \
     then L, the light; . is any surface, and * + ? | ( ) [DG] [^S] are those of regular expressions"
)]
pub struct PatternError {
    text: String,
    why: String,
}

impl PatternError {
    pub(super) fn new(text: &str, why: impl Into<String>) -> Self {
        Self {
            text: text.to_owned(),
            why: why.into(),
        }
    }
}

/// Letters, at most: a channel's name in an EXR has 255 bytes.
const LONGEST: usize = 200;

/// The expression of a pattern; whether its brackets fit together, its reader sees.
pub(super) fn expression(text: &str) -> Result<String, PatternError> {
    let wrong = |why: String| PatternError::new(text, why);
    if text.len() > LONGEST {
        return Err(wrong(format!("more than {LONGEST} letters")));
    }
    let mut expression = String::new();
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        match c {
            'E' | 'L' | 'D' | 'G' | 'S' | '*' | '+' | '?' | '|' | '(' | ')' => expression.push(c),
            '.' => expression += "[DGS]",
            '[' => {
                let (set, after) = rest
                    .as_str()
                    .split_once(']')
                    .ok_or_else(|| wrong("a [ has no ]".to_owned()))?;
                expression += &of_set(set).ok_or_else(|| {
                    wrong(format!(
                        "[{set}] is no set of D, G and S, or one with nothing in it"
                    ))
                })?;
                rest = after.chars();
            }
            other => return Err(wrong(format!("{other:?} means nothing in it"))),
        }
    }
    Ok(expression)
}

/// What stands between `[` and `]`: letters, or after `^` those that it is not; `None` where that is nothing.
fn of_set(set: &str) -> Option<String> {
    let (letters, inside) = match set.strip_prefix('^') {
        Some(letters) => (letters, false),
        None => (set, true),
    };
    let bytes = Letter::ALL.map(Letter::byte).map(char::from);
    let known = !letters.is_empty() && letters.chars().all(|c| bytes.contains(&c));
    let chosen: String = bytes
        .into_iter()
        .filter(|&c| letters.contains(c) == inside)
        .collect();
    (known && !chosen.is_empty()).then(|| format!("[{chosen}]"))
}
