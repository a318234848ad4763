//! `vkpt test FOLDER`: compares scenes with the expected pictures next to them.

mod arguments;
mod picture;
mod scenes;

use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use self::picture::{Rendered, difference, expected, heat, png, put, rendered};
use self::scenes::{Found, beside, scenes};
use crate::cli::console::Console;
use crate::cli::destination::{all_written, whole};
use crate::cli::exit::{Ending, Failure, warn};
use crate::cli::interrupt::stop_flag;
use crate::cli::progress::Display;
use crate::cli::writable;
use crate::suite::report::{Case, Shown, Suite, Verdict, junit, line, page, sum};
pub use arguments::TestArguments;
use vkpt::film::Film;
use vkpt::image::Picture;
use vkpt::image::file::FileError;

/// Renders every scene, compares it with its expected picture and prints a line for each.
pub fn test(arguments: &TestArguments) -> Result<Ending, Failure> {
    let folder = &arguments.folder;
    let found = scenes(folder).map_err(|error| Failure::Usage(error.to_string()))?;
    if found.is_empty() {
        return Err(Failure::Usage(format!(
            "{} contains no scenes, which are files that end in .txt, .scn, .gltf or .glb",
            folder.display()
        )));
    }
    make_room(arguments)?;
    let _claims = writable::check(arguments.reports())?;
    let console = Console::beside(arguments.reports());
    let stop = stop_flag();
    let mut display = Display::new(arguments.quiet);
    let mut suite = Suite::default();
    let mut ended = Ok(Ending::Complete);
    for (i, one) in found.iter().enumerate() {
        display.case(i, found.len(), &name(one));
        let case = match case(arguments, one, &stop, &mut display) {
            Ok(Some(case)) => case,
            Ok(None) => {
                warn("interrupted: the remaining scenes were not rendered");
                ended = Ok(Ending::Interrupted);
                break;
            }
            // All others would fail in the same way.
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
    let printed = match arguments.quiet {
        true => Ok(()),
        false => console.print(&sum(&suite)),
    };
    let label = folder.display().to_string();
    let html = whole(&arguments.html, || {
        page(&suite, &label).map_err(std::io::Error::other)
    });
    all_written([
        printed,
        whole(&arguments.junit, || junit(&suite, &label)),
        html,
    ])?;
    match (ended, suite.wrong()) {
        (Ok(_), 1..) => Err(Failure::Comparison(Vec::new())),
        (ended, _) => ended,
    }
}

/// Creates the folder for pictures that differ, if a report goes there, too.
fn make_room(arguments: &TestArguments) -> Result<(), Failure> {
    let mut folders = arguments
        .reports()
        .filter_map(|to| to.neighbour()?.parent());
    match folders.any(|folder| folder == arguments.out) {
        true => make_folder(&arguments.out),
        false => Ok(()),
    }
}

/// Creates a folder and its parents.
fn make_folder(path: &Path) -> Result<(), Failure> {
    fs::create_dir_all(path).map_err(|cause| {
        let path = path.to_owned();
        Failure::Files(vec![FileError { path, cause }])
    })
}

/// Its file, or if that is gone its picture, relative to the folder.
fn name(found: &Found) -> String {
    let file = found.scene.as_ref().unwrap_or(&found.expected);
    let folder = found.stem.parent().unwrap_or(Path::new(""));
    let path = folder.join(file.file_name().unwrap_or_default());
    path.to_string_lossy()
        .replace(std::path::MAIN_SEPARATOR, "/")
}

/// One scene; `None` if a signal ended it. Errors of the scene itself become its verdict.
fn case(
    arguments: &TestArguments,
    found: &Found,
    stop: &AtomicBool,
    display: &mut Display,
) -> Result<Option<Case>, Failure> {
    let began = Instant::now();
    let tried = match tried(arguments, found, stop, display) {
        Ok(Some(tried)) => tried,
        Ok(None) => return Ok(None),
        Err(failure) if failure.is_of_input() => failed(failure.messages().join("\n")),
        Err(failure) => return Err(failure),
    };
    Ok(Some(Case {
        name: name(found),
        seconds: began.elapsed().as_secs_f64(),
        verdict: tried.verdict,
        files: tried.files,
        shown: tried.shown,
    }))
}

/// A verdict, and the pictures that show it.
struct Tried {
    verdict: Verdict,
    files: Vec<String>,
    shown: Option<Shown>,
}

impl From<Verdict> for Tried {
    fn from(verdict: Verdict) -> Self {
        Self {
            verdict,
            files: Vec::new(),
            shown: None,
        }
    }
}

fn failed(why: String) -> Tried {
    Verdict::Failed(why).into()
}

fn tried(
    arguments: &TestArguments,
    found: &Found,
    stop: &AtomicBool,
    display: &mut Display,
) -> Result<Option<Tried>, Failure> {
    let Some(scene) = &found.scene else {
        let why = "no scene next to it: remove the picture, or restore the scene";
        return Ok(Some(failed(why.to_owned())));
    };
    let expected = match expected(&found.expected) {
        // A picture that cannot be read is replaced.
        Err(_) if arguments.bless => None,
        read => read?,
    };
    let name = name(found);
    let mut made = || rendered(arguments, scene, &name, stop, &mut |p| display.update(p));
    let tried = match (expected, arguments.bless) {
        (expected, true) => match made()? {
            Some(made) => kept(found, &made, expected.as_ref())?,
            None => return Ok(None),
        },
        (Some(expected), false) => match made()? {
            Some(made) => judged(arguments, found, &made, &expected)?,
            None => return Ok(None),
        },
        (None, false) => failed(format!(
            "{} does not exist: use --bless to keep the picture rendered now",
            found.expected.display()
        )),
    };
    Ok(Some(tried))
}

/// Keeps the picture, unless it equals the expected one.
fn kept(found: &Found, made: &Rendered, expected: Option<&Picture>) -> Result<Tried, Failure> {
    if expected.is_some_and(|expected| difference(&made.picture, expected).is_none()) {
        return Ok(Verdict::Same.into());
    }
    let instead = found.expected.exists();
    all_written([put(&found.expected, &made.bytes)])?;
    Ok(Verdict::Kept { instead }.into())
}

/// Compares the picture with the expected one, and shows where they differ.
fn judged(
    arguments: &TestArguments,
    found: &Found,
    made: &Rendered,
    expected: &Picture,
) -> Result<Tried, Failure> {
    match (difference(&made.picture, expected), arguments.max_relmse) {
        (None, _) => Ok(Verdict::Same.into()),
        (Some((Some(rel_mse), _)), Some(most)) if rel_mse <= most => {
            Ok(Verdict::Close { rel_mse }.into())
        }
        (Some((_, why)), _) => {
            let heat = heat(&made.picture, expected);
            let files = show(&arguments.out.join(&found.stem), made, heat.as_ref())?;
            let shown = Shown {
                expected: expected.film.clone(),
                actual: made.picture.film.clone(),
                heat,
            };
            Ok(Tried {
                verdict: Verdict::Differs(why),
                files,
                shown: Some(shown),
            })
        }
    }
}

/// Writes the picture and a map of its differences, for people to inspect; returns the names.
fn show(stem: &Path, made: &Rendered, heat: Option<&Film>) -> Result<Vec<String>, Failure> {
    make_folder(stem.parent().unwrap_or(Path::new("")))?;
    let actual = beside(stem, ".actual.exr");
    all_written([put(&actual, &made.bytes)])?;
    let mut names = vec![actual.display().to_string()];
    // Only for pictures of equal size.
    if let Some(map) = heat {
        let difference = beside(stem, ".difference.png");
        all_written([put(&difference, &png(map)?)])?;
        names.push(difference.display().to_string());
    }
    Ok(names)
}
