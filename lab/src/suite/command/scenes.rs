//! The scenes of a folder, and the expected pictures next to them.

use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Endings of scene files.
const SCENES: [&str; 4] = ["txt", "scn", "gltf", "glb"];
const EXPECTED: &str = ".expected.exr";

/// A scene file, its picture, or both.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Found {
    /// Path without ending, relative to the folder.
    pub stem: PathBuf,
    /// `None` if only the expected picture exists.
    pub scene: Option<PathBuf>,
    /// The path; the file may not exist.
    pub expected: PathBuf,
}

/// All scenes of `folder` and the folders in it, sorted by name; names that begin with a dot are skipped.
///
/// # Errors
/// Folders that cannot be read; two scenes with one picture.
pub fn scenes(folder: &Path) -> io::Result<Vec<Found>> {
    let mut files = Vec::new();
    walk(folder, &mut files)?;
    let mut all: Vec<Found> = Vec::new();
    for scene in files.iter().filter(|file| is_scene(file)) {
        let stem = scene.with_extension("");
        let expected = beside(&stem, EXPECTED);
        if all.iter().any(|other| other.expected == expected) {
            return Err(io::Error::other(format!(
                "two scenes would have the same expected picture, {}: give one of them another name",
                expected.display()
            )));
        }
        all.push(Found {
            stem: seen_from(folder, &stem),
            scene: Some(scene.clone()),
            expected,
        });
    }
    for expected in files {
        let Some(stem) = expected
            .to_str()
            .and_then(|name| name.strip_suffix(EXPECTED))
        else {
            continue;
        };
        if all.iter().all(|other| other.expected != expected) {
            all.push(Found {
                stem: seen_from(folder, Path::new(stem)),
                scene: None,
                expected: expected.clone(),
            });
        }
    }
    all.sort();
    Ok(all)
}

/// `stem` with an ending, which may have dots before it.
pub fn beside(stem: &Path, ending: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(ending);
    name.into()
}

fn is_scene(file: &Path) -> bool {
    let ending = file.extension().and_then(OsStr::to_str);
    ending.is_some_and(|ending| SCENES.contains(&ending))
}

fn seen_from(folder: &Path, path: &Path) -> PathBuf {
    path.strip_prefix(folder).unwrap_or(path).to_owned()
}

/// The files of `folder` and of the folders in it.
fn walk(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let named = |error: io::Error| io::Error::other(format!("{}: {error}", folder.display()));
    let entries: io::Result<Vec<_>> = fs::read_dir(folder).map_err(named)?.collect();
    let mut entries = entries.map_err(named)?;
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let is_hidden = entry.file_name().as_encoded_bytes().starts_with(b".");
        let kind = entry.file_type().map_err(named)?;
        match () {
            () if is_hidden => {}
            // A link to a folder may lead in circles, so it is not followed.
            () if kind.is_dir() => walk(&entry.path(), files)?,
            () => files.push(entry.path()),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_and_pictures_find_one_another() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at("in/.git")).expect("folders");
        for name in [
            "b.scn",
            "b.expected.exr",
            "a.b.txt",
            "in/c.glb",
            "gone.expected.exr",
            "b.png",
            "in/.git/d.txt",
            ".e.txt",
        ] {
            fs::write(at(name), "").expect("a file");
        }
        let found = scenes(folder.path()).expect("scenes");
        let names: Vec<_> = found
            .iter()
            .map(|f| (f.stem.to_str().expect("a name"), f.scene.is_some()))
            .collect();
        assert_eq!(
            names,
            [("a.b", true), ("b", true), ("gone", false), ("in/c", true)]
        );
        assert_eq!(found[0].expected, at("a.b.expected.exr"));
        assert_eq!(found[3].expected, at("in/c.expected.exr"));
        fs::write(at("b.txt"), "").expect("a file");
        let error = scenes(folder.path()).expect_err("two").to_string();
        assert!(
            error.contains("b.expected.exr: give one of them another name"),
            "{error}"
        );
        let error = scenes(&at("none")).expect_err("no folder").to_string();
        assert!(error.contains("none: "), "{error}");
    }
}
