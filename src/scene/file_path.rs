//! Resolves the file name on a line, either as written or as a machine with other rules for names would spell it.

use std::fs;
use std::path::{Component, Path, PathBuf};

use super::arguments::Arguments;
use super::commands::closest;
use super::diagnostic::Place;
use super::log::Log;
use super::text::{Token, shorten};

/// A file named on a line.
pub(super) struct FilePath {
    pub(super) path: PathBuf,
    pub(super) place: Place,
}

/// Takes FILE off the line. A file that exists under another spelling is read with a warning: back slashes, another
/// case, quotes, blanks. `folder` is the scene file's; `is_name` recognises the extensions of such files.
pub(super) fn file_path(
    folder: &Path,
    arguments: &mut Arguments,
    log: &mut Log,
    is_name: fn(&Path) -> bool,
) -> Option<FilePath> {
    let first = arguments.word(log, "FILE")?;
    let whole = |place, name: &str| FilePath {
        path: resolve(folder, name),
        place,
    };
    if resolve(folder, first.text).exists() {
        return Some(whole(first.place, first.text));
    }
    let words = words(first, arguments.rest(), is_name);
    let name = words
        .iter()
        .map(|word| word.text)
        .collect::<Vec<_>>()
        .join(" ");
    let bare = name.trim_matches(['"', '\'']);
    let place = first.place.to(words[words.len() - 1].place);
    match spelled_otherwise(folder, bare) {
        Some(path) => {
            let message = format!("`{}` is read as {}", shorten(&name), path.display());
            let label = match words.len() > 1 && bare == name && resolve(folder, bare) == path {
                true => "a blank ends a name",
                false => "no file has exactly this name",
            };
            log.warning(place, message, label);
            words[1..].iter().for_each(|_| arguments.skip_one());
            Some(FilePath { path, place })
        }
        None if bare != name => {
            words[1..].iter().for_each(|_| arguments.skip_one());
            Some(whole(place, bare))
        }
        None => Some(whole(first.place, first.text)),
    }
}

/// The words of a name that begins with `first`: up to the closing quote, or to the first word with a recognised
/// extension. Only `first` if there is neither.
fn words<'t>(first: Token<'t>, rest: &[Token<'t>], is_name: fn(&Path) -> bool) -> Vec<Token<'t>> {
    let all = || std::iter::once(first).chain(rest.iter().copied());
    let is_last = |token: &Token| match first.text.chars().next() {
        Some(quote @ ('"' | '\'')) => token.text.ends_with(quote) && token.text.len() > 1,
        _ => is_name(Path::new(token.text)),
    };
    let length = all()
        .position(|token| is_last(&token))
        .map_or(1, |last| last + 1);
    all().take(length).collect()
}

/// `name` relative to the scene file, or else to the working directory.
fn resolve(folder: &Path, name: &str) -> PathBuf {
    let beside = folder.join(name);
    match !beside.exists() && Path::new(name).exists() {
        true => name.into(),
        false => beside,
    }
}

/// An existing file with this name but for the direction of slashes and the case of letters.
fn spelled_otherwise(folder: &Path, name: &str) -> Option<PathBuf> {
    let slashed = name.replace('\\', "/");
    let beside = |name: &str| Some(resolve(folder, name)).filter(|path| path.is_file());
    beside(name).or_else(|| beside(&slashed)).or_else(|| {
        let folders = [folder, Path::new("")].into_iter();
        folders
            .filter_map(|folder| in_any_case(folder, Path::new(&slashed)))
            .next()
    })
}

/// The only file in `folder` that matches this path when case is ignored.
fn in_any_case(folder: &Path, path: &Path) -> Option<PathBuf> {
    let mut found = folder.to_owned();
    for part in path.components() {
        let next = found.join(part);
        let Component::Normal(name) = part else {
            found = next;
            continue;
        };
        found = match next.exists() {
            true => next,
            false => {
                let wanted = name.to_string_lossy().to_lowercase();
                let mut same = entries(&found)
                    .into_iter()
                    .filter(|name| name.to_lowercase() == wanted);
                match (same.next(), same.next()) {
                    (Some(name), None) => found.join(name),
                    _ => return None,
                }
            }
        };
    }
    found.is_file().then_some(found)
}

/// A file with a similar name, in the folder of the missing one or next to the scene file.
pub(super) fn similar(folder: &Path, missing: &Path, is_name: fn(&Path) -> bool) -> Option<String> {
    let name = missing.file_name()?.to_string_lossy().replace('\\', "/");
    let name = name.rsplit('/').next()?;
    [missing.parent()?, folder].into_iter().find_map(|folder| {
        let names = entries(folder);
        let named: Vec<&str> = names
            .iter()
            .map(|name| &**name)
            .filter(|name| is_name(Path::new(name)))
            .collect();
        closest(name, &named).map(str::to_owned)
    })
}

/// The names in a folder; an empty `folder` is the working directory.
fn entries(folder: &Path) -> Vec<String> {
    let folder = if folder == Path::new("") {
        Path::new(".")
    } else {
        folder
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    names.sort();
    names
}
