//! Checks outputs before the work starts: that they can be written, that nothing is lost, and that no other process is
//! writing them.

use std::path::{Path, PathBuf};

use same_file::Handle;

use super::destination::{Destination, all_written};
use super::exit::Failure;
use super::streams::Stream;
use vkpt::image::claim::Claim;
use vkpt::image::file::check_writable;
use vkpt::image::place::{Place, folder};

/// Files that no other vkpt writes while this exists.
#[derive(Debug, Default)]
#[must_use = "the files are free again once this is dropped"]
pub struct Claims {
    _all: Vec<Claim>,
}

/// Checks that every file can be written, no two go to one place, and no other vkpt writes one.
pub fn check<'a>(files: impl IntoIterator<Item = &'a Destination>) -> Result<Claims, Failure> {
    let files: Vec<&Destination> = files.into_iter().collect();
    let named = files.iter().filter(|file| file.stream().is_none());
    let paths: Vec<&Path> = named.filter_map(|file| file.path()).collect();
    all_written(paths.iter().map(|path| check_writable(path)))?;
    apart(&files)?;
    let mut all = Vec::new();
    let claim = |path: &&Path| Claim::new(path).map(|claim| all.push(claim));
    let claimed: Vec<_> = paths.iter().map(claim).collect();
    all_written(claimed)?;
    Ok(Claims { _all: all })
}

/// Checks that no two go to one place.
fn apart(files: &[&Destination]) -> Result<(), Failure> {
    let goals: Vec<Option<Goal>> = files.iter().map(|file| Goal::of(file)).collect();
    let twice = |i: &usize| goals[*i].is_some() && goals[..*i].contains(&goals[*i]);
    let Some(i) = (1..files.len()).find(twice) else {
        return Ok(());
    };
    Err(Failure::Usage(match files[i].stream() {
        Some(stream) => format!(
            "two outputs would be written to {}: give one of them a file name",
            stream.name().display()
        ),
        None => format!(
            "two outputs would be written to the same file, {}: give one of them another name",
            files[i]
        ),
    }))
}

/// A place that only one output may use.
#[derive(Debug, PartialEq, Eq)]
enum Goal {
    Stream(Stream),
    /// An existing file.
    Known(Handle),
    /// A new file: its folder's canonical name, and the file's.
    New(PathBuf),
    /// A pipe, by its device and number: its reader would get both outputs in one.
    Pipe([u64; 2]),
}

impl Goal {
    /// `None` for places that any number of outputs may use, such as /dev/null.
    fn of(to: &Destination) -> Option<Self> {
        if let Some(stream) = to.stream() {
            return Some(Self::Stream(stream));
        }
        if let Some(file) = to.identity() {
            return Some(Self::Known(file));
        }
        match Place::of(to.path()?).ok()? {
            Place::Straight(path) => pipe(&path).map(Self::Pipe),
            Place::File(path) => {
                let folder = folder(&path).canonicalize().ok()?;
                Some(Self::New(folder.join(path.file_name()?)))
            }
        }
    }
}

#[cfg(unix)]
fn pipe(path: &Path) -> Option<[u64; 2]> {
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let there = path.metadata().ok()?;
    let is_pipe = there.file_type().is_fifo();
    is_pipe.then(|| [there.dev(), there.ino()])
}

#[cfg(not(unix))]
fn pipe(_: &Path) -> Option<[u64; 2]> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_place_by_two_names_is_a_mistake_of_the_command_line() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| match name {
            "-" => Destination::Stdout,
            _ => Destination::File(folder.path().join(name)),
        };
        std::fs::create_dir(folder.path().join("in")).expect("a folder");
        let check = |names: [&str; 3]| check(&names.map(path));
        assert!(check(["a", "b", "-"]).is_ok());
        assert!(check(["a", "in/a", "in/b"]).is_ok());
        for same in [
            ["a", "b", "a"],
            ["a", "in/../a", "b"],
            ["./in/b", "-", "in/b"],
            ["-", "a", "-"],
        ] {
            assert!(matches!(check(same), Err(Failure::Usage(_))), "{same:?}");
        }
        let errors = check(["none/a", "in", "-"]);
        assert!(matches!(errors, Err(Failure::Files(files)) if files.len() == 2));
    }
}
