//! Translates a user's pattern to a regular expression over the letters of paths.

use super::{Letter, Side};

/// An invalid pattern, and why.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{text:?} is not a class of paths: {why}. Write E for the eye, then D (diffuse), G (rough) or S (smooth) for each surface, \
     R or T for any that reflects or transmits, <TS> for one that transmits smoothly, then L for the light; . is any surface, \
     and * + ? | ( ) [DG] [^S] are as in regular expressions"
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

/// Maximum number of letters: a channel's name in an EXR has at most 255 bytes.
const LONGEST: usize = 200;

/// The expression of a pattern. The regular expression's own parser checks that brackets match.
pub(super) fn expression(text: &str) -> Result<String, PatternError> {
    let wrong = |why: String| PatternError::new(text, why);
    if text.len() > LONGEST {
        return Err(wrong(format!("more than {LONGEST} letters")));
    }
    let mut expression = String::new();
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        match c {
            'E' | 'L' | '*' | '+' | '?' | '|' | '(' | ')' => expression.push(c),
            '[' | '<' => {
                let (inside, after) = bracketed(c, rest.as_str()).map_err(wrong)?;
                expression += &inside;
                rest = after.chars();
            }
            other => {
                expression += &any_of(|letter| means(other, letter) == Some(true))
                    .ok_or_else(|| wrong(format!("{other:?} has no meaning in it")))?;
            }
        }
    }
    Ok(expression)
}

/// The expression of the bracket that `open` begins, and the text after it; otherwise an error message.
fn bracketed(open: char, rest: &str) -> Result<(String, &str), String> {
    let close = if open == '[' { ']' } else { '>' };
    let (inside, after) = rest
        .split_once(close)
        .ok_or_else(|| format!("a {open} lacks its {close}"))?;
    let of = match open {
        '[' => of_set(inside).ok_or("a non-empty set of D, G, S, R and T"),
        _ => of_pair(inside).ok_or("R or T followed by D, G or S, or no surface does both"),
    };
    let expression = of.map_err(|what| format!("{open}{inside}{close} is not {what}"))?;
    Ok((expression, after))
}

/// Between `[` and `]`: letters, or after `^` the excluded letters.
fn of_set(set: &str) -> Option<String> {
    let (names, inside) = match set.strip_prefix('^') {
        Some(names) => (names, false),
        None => (set, true),
    };
    let known = !names.is_empty() && names.chars().all(|name| "DGSRT".contains(name));
    let named = |letter| names.chars().any(|name| means(name, letter) == Some(true));
    any_of(|letter| named(letter) == inside).filter(|_| known)
}

/// Between `<` and `>`, as in the light path expressions of other renderers: a side, and a kind of scattering.
fn of_pair(pair: &str) -> Option<String> {
    let mut names = pair.chars();
    let (side, event) = (names.next()?, names.next()?);
    let known = "RT".contains(side) && "DGS".contains(event) && names.next().is_none();
    let both = |letter| [side, event].map(|name| means(name, letter)) == [Some(true); 2];
    any_of(both).filter(|_| known)
}

/// The expression for the chosen letters; `None` if there are none.
fn any_of(chosen: impl Fn(Letter) -> bool) -> Option<String> {
    let letters = Letter::ALL.into_iter().filter(|&letter| chosen(letter));
    let bytes: String = letters.map(|letter| char::from(letter.byte())).collect();
    (!bytes.is_empty()).then(|| format!("[{bytes}]"))
}

/// Whether `name`, in a user's pattern, includes this letter; `None` for an unknown name.
fn means(name: char, letter: Letter) -> Option<bool> {
    Some(match name {
        '.' => true,
        'D' => letter == Letter::D,
        'G' => matches!(letter, Letter::G(_)),
        'S' => matches!(letter, Letter::S(_)),
        'R' => letter.side() == Side::R,
        'T' => letter.side() == Side::T,
        _ => return None,
    })
}
