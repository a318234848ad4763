//! `vkpt test FOLDER`: scenes against the pictures that are kept beside them.

mod arguments;
mod picture;
mod scenes;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use self::picture::{Rendered, difference, expected, heat, png, put, rendered};
use self::scenes::{Found, beside, scenes};
use super::console::Console;
use super::destination::{all_written, whole};
use super::exit::{Ending, Failure, warn};
use super::interrupt::stop_flag;
use super::progress::Display;
use super::writable;
use crate::image::Picture;
use crate::image::file::FileError;
use crate::report::suite::{Case, Suite, Verdict, junit, line, sum};
pub use arguments::TestArguments;

/// Renders every scene, compares it with its picture and prints a line of each.
pub fn test(arguments: &TestArguments) -> Result<Ending, Failure> {
    let folder = &arguments.folder;
    let found = scenes(folder).map_err(|error| Failure::Usage(error.to_string()))?;
    if found.is_empty() {
        return Err(Failure::Usage(format!(
            "there are no scenes in {}: files that end in .txt, .scn, .gltf or .glb",
            folder.display()
        )));
    }
    let _claims = writable::check(&arguments.junit)?;
    let console = Console::beside(&arguments.junit);
    let stop = stop_flag();
    let mut display = Display::new(arguments.quiet);
    let mut suite = Suite::default();
    let mut ended = Ok(Ending::Complete);
    for (i, one) in found.iter().enumerate() {
        display.case(i, found.len(), &name(one));
        let case = match case(arguments, one, &stop, &mut display) {
            Ok(Some(case)) => case,
            Ok(None) => {
                warn("interrupted: the other scenes are not tried");
                ended = Ok(Ending::Interrupted);
                break;
            }
            // All others would end so, too.
            Err(failure) => {
                ended = Err(failure);
                break;
            }
        };
        if !arguments.quiet || case.verdict.wrong().is_some() {
            display.finish();
            all_written([console.print(&line(&case))])?;
        }
        suite.cases.push(case);
    }
    display.finish();
    let told = match arguments.quiet {
        true => Ok(()),
        false => console.print(&sum(&suite)),
    };
    let label = folder.display().to_string();
    all_written([told, whole(&arguments.junit, || junit(&suite, &label))])?;
    match (ended, suite.wrong()) {
        (Ok(_), 1..) => Err(Failure::Comparison(Vec::new())),
        (ended, _) => ended,
    }
}

/// Its file, or where that is gone its picture, seen from the folder.
fn name(found: &Found) -> String {
    let file = found.scene.as_ref().unwrap_or(&found.expected);
    let folder = found.stem.parent().unwrap_or(Path::new(""));
    let path = folder.join(file.file_name().unwrap_or_default());
    path.to_string_lossy()
        .replace(std::path::MAIN_SEPARATOR, "/")
}

/// One scene; `None` where a signal ended it. What is wrong with it alone is its verdict.
fn case(
    arguments: &TestArguments,
    found: &Found,
    stop: &AtomicBool,
    display: &mut Display,
) -> Result<Option<Case>, Failure> {
    let began = Instant::now();
    let mut files = Vec::new();
    let verdict = match verdict(arguments, found, stop, display, &mut files) {
        Ok(Some(verdict)) => verdict,
        Ok(None) => return Ok(None),
        Err(failure) if failure.is_of_input() => Verdict::Failed(failure.messages().join("\n")),
        Err(failure) => return Err(failure),
    };
    Ok(Some(Case {
        name: name(found),
        seconds: began.elapsed().as_secs_f64(),
        verdict,
        files,
    }))
}

fn verdict(
    arguments: &TestArguments,
    found: &Found,
    stop: &AtomicBool,
    display: &mut Display,
    files: &mut Vec<String>,
) -> Result<Option<Verdict>, Failure> {
    let Some(scene) = &found.scene else {
        return Ok(Some(Verdict::Failed(
            "there is no scene beside it: take the picture away, or bring the scene back"
                .to_owned(),
        )));
    };
    let expected = match expected(&found.expected) {
        // What can't be read is kept anew.
        Err(_) if arguments.bless => None,
        read => read?,
    };
    if expected.is_none() && !arguments.bless {
        return Ok(Some(Verdict::Failed(format!(
            "there is no {}: --bless keeps the picture that it makes now",
            found.expected.display()
        ))));
    }
    let made = rendered(arguments, scene, &name(found), stop, &mut |p| {
        display.update(p)
    })?;
    let Some(Rendered { bytes, picture }) = made else {
        return Ok(None);
    };
    let other = expected
        .as_ref()
        .map(|expected| difference(&picture, expected));
    Ok(Some(match (other, arguments.max_relmse) {
        (Some(None), _) => Verdict::Same,
        (other, _) if arguments.bless => {
            let instead = other.is_some() || found.expected.exists();
            all_written([put(&found.expected, &bytes)])?;
            Verdict::Kept { instead }
        }
        (Some(Some((Some(rel_mse), _))), Some(most)) if rel_mse <= most => {
            Verdict::Close { rel_mse }
        }
        (Some(Some((_, why))), _) => {
            let stem = arguments.out.join(&found.stem);
            *files = shown(&stem, &bytes, &picture, expected.as_ref())?;
            Verdict::Differs(why)
        }
        (None, _) => Verdict::Failed("there is nothing to compare it with".to_owned()),
    }))
}

/// Writes the picture and where it differs, for people to look at; returns the names.
fn shown(
    stem: &Path,
    bytes: &[u8],
    actual: &Picture,
    expected: Option<&Picture>,
) -> Result<Vec<String>, Failure> {
    let folder = stem.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder).map_err(|cause| {
        Failure::Files(vec![FileError {
            path: folder.to_owned(),
            cause,
        }])
    })?;
    let mut all: Vec<(PathBuf, Vec<u8>)> = vec![(beside(stem, ".actual.exr"), bytes.to_vec())];
    if let Some(map) = expected.and_then(|expected| heat(actual, expected)) {
        all.push((beside(stem, ".difference.png"), png(&map)?));
    }
    all_written(all.iter().map(|(path, bytes)| put(path, bytes)))?;
    Ok(all
        .iter()
        .map(|(path, _)| path.display().to_string())
        .collect())
}
