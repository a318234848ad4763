//! Reports in files: whether they can be written, found out before the work starts, and how they are written after it.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::exit::Failure;
use crate::image::file::{FileError, check_writable, write_whole};

/// Each path can be written, and no two are the same file; touches nothing.
pub fn check_all<'a>(paths: impl Iterator<Item = &'a Path>) -> Result<(), Failure> {
    let paths: Vec<&Path> = paths.collect();
    all(paths.iter().map(|path| check_writable(path)))?;
    let mut places: Vec<PathBuf> = paths.iter().map(|path| place(path)).collect();
    places.sort();
    match places.windows(2).find(|pair| pair[0] == pair[1]) {
        None => Ok(()),
        Some(pair) => Err(Failure::Usage(format!(
            "two reports would be written to one file, {}",
            pair[0].display()
        ))),
    }
}

/// Where a file stands, by whatever way its folder is named.
fn place(path: &Path) -> PathBuf {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    match (folder.canonicalize(), path.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => path.to_owned(),
    }
}

/// Writes a text, if it was asked for.
pub fn whole(
    path: Option<&Path>,
    text: impl FnOnce() -> io::Result<String>,
) -> Result<(), FileError> {
    let Some(path) = path else { return Ok(()) };
    write_whole(path, |out| out.write_all(text()?.as_bytes()))
}

/// A record as JSON to read, ending in a line break.
pub fn json(record: &impl serde::Serialize) -> io::Result<String> {
    Ok(serde_json::to_string_pretty(record)? + "\n")
}

/// Every file that could not be written is told.
pub fn all(written: impl IntoIterator<Item = Result<(), FileError>>) -> Result<(), Failure> {
    let errors: Vec<FileError> = written.into_iter().filter_map(Result::err).collect();
    match errors.is_empty() {
        true => Ok(()),
        false => Err(Failure::Files(errors)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_file_by_two_names_is_a_mistake_of_the_command_line() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        std::fs::create_dir(path("in")).expect("a folder");
        let check = |names: [&str; 2]| {
            let paths = names.map(path);
            check_all(paths.iter().map(PathBuf::as_path))
        };
        assert!(check(["a", "b"]).is_ok());
        assert!(check(["a", "in/a"]).is_ok());
        for same in [["a", "a"], ["a", "in/../a"], ["./in/b", "in/b"]] {
            assert!(matches!(check(same), Err(Failure::Usage(_))), "{same:?}");
        }
        let errors = check(["none/a", "in"]);
        assert!(matches!(errors, Err(Failure::Files(told)) if told.len() == 2));
    }
}
