//! Everything outside: `background`, a constant radiance or a picture, and `ibl`.

use std::path::Path;
use std::sync::Arc;

use glam::DVec3;

use super::Surroundings;
use super::arguments::Arguments;
use super::builder::Builder;
use super::diagnostic::Place;
use super::field::{RADIANCE, positive, vector};
use super::file_path::{FilePath, file_path, similar};
use super::log::Log;
use super::number::prefix_length;
use super::orientation::orientation;
use crate::film::Film;
use crate::image::{DecodeError, Format, Picture, Precision, read};

/// The value of `background`.
#[derive(Clone, Debug)]
pub(super) enum Outside {
    Constant(DVec3),
    Picture(Surroundings),
}

/// `background r g b`, or with the arguments of `ibl`
pub(super) fn background(builder: &mut Builder, arguments: &mut Arguments) {
    if names_a_file(arguments) {
        return picture(builder, arguments);
    }
    let radiance = arguments.numbers(&mut builder.log, RADIANCE);
    let outside = radiance.map(|radiance| Outside::Constant(vector(&radiance)));
    set(builder, arguments, outside);
}

/// `ibl FILE [SCALE] ORIENTATION`, as other programs of the course have it. In their scene files a sphere around the
/// eye follows, which carries the picture; here it is not a shape.
pub(super) fn ibl(builder: &mut Builder, arguments: &mut Arguments) {
    picture(builder, arguments);
    builder.expect_carrier();
}

fn set(builder: &mut Builder, arguments: &Arguments, outside: Option<Outside>) {
    let command = arguments.command();
    let outside = outside.map(|outside| (outside, command.place.line));
    builder.background.set(outside, command, &mut builder.log);
}

/// Whether any word ends like the name of a picture, or the first one has any other extension.
fn names_a_file(arguments: &Arguments) -> bool {
    let rest = arguments.rest();
    let named = |text: &str| {
        let ending = Path::new(text).extension().is_some();
        prefix_length(text) == 0 && ending
    };
    let first = rest.first().is_some_and(|token| named(token.text));
    first
        || rest
            .iter()
            .any(|token| is_picture_name(Path::new(token.text)))
}

fn is_picture_name(path: &Path) -> bool {
    let ending = path.to_string_lossy();
    let bare = ending.trim_end_matches(['"', '\'']);
    Format::of(Path::new(bare)).is_some()
}

/// `FILE [SCALE] ORIENTATION`
fn picture(builder: &mut Builder, arguments: &mut Arguments) {
    let folder = builder.folder().to_owned();
    let log = &mut builder.log;
    let file = file_path(&folder, arguments, log, is_picture_name);
    let scale = scale(arguments, log);
    let rotate = orientation(arguments, log);
    let read = file.and_then(|file| {
        let picture = radiances(&folder, &file, log)?;
        Some((file.path, picture))
    });
    let all = read.zip(scale).zip(rotate);
    let surroundings = all.map(|(((path, picture), scale), rotate)| {
        Outside::Picture(Surroundings {
            path,
            picture: Arc::new(picture),
            scale,
            rotate,
        })
    });
    set(builder, arguments, surroundings);
}

/// The optional next number, by default 1.
fn scale(arguments: &mut Arguments, log: &mut Log) -> Option<f64> {
    match arguments.rest().first() {
        Some(token) if prefix_length(token.text) > 0 => {
            let [scale] = arguments.numbers(log, [positive("SCALE", "the scale")])?;
            Some(scale.value)
        }
        _ => Some(1.0),
    }
}

/// Reads the picture. Negative values, left by filters of other programs, count as 0.
fn radiances(folder: &Path, file: &FilePath, log: &mut Log) -> Option<Film> {
    let FilePath { path, place } = file;
    let mut film = match read(path) {
        Ok(picture) => whole(picture, path, *place, log)?,
        Err(error) => {
            let missing = matches!(&error.cause, DecodeError::Io(e) if e.kind() == std::io::ErrorKind::NotFound);
            let message = match missing {
                true => format!("{}: no such file", path.display()),
                false => error.to_string(),
            };
            let message = log.error(*place, message, "");
            if missing {
                message.help(match similar(folder, path, is_picture_name) {
                    Some(name) => format!("did you mean `{name}`?"),
                    None => LOOKED_FOR.to_owned(),
                });
            }
            return None;
        }
    };
    let mut negative = 0;
    for value in film.rgb.as_flattened_mut().iter_mut().filter(|v| **v < 0.0) {
        *value = 0.0;
        negative += 1;
    }
    if negative > 0 {
        let message = format!("{}: {negative} of its values are negative", path.display());
        log.warning(*place, message, "taken as 0");
    }
    Some(film)
}

/// A picture that covers all directions; otherwise an error.
fn whole(picture: Picture, path: &Path, place: Place, log: &mut Log) -> Option<Film> {
    let Film { width, height, .. } = picture.film;
    let wrong = match picture {
        Picture {
            precision: Precision::Srgb { .. },
            ..
        } => "a PNG has no radiances: use an EXR (.exr) or HDR (.hdr) for surroundings",
        Picture { origin, full, .. } if origin != [0, 0] || full != [width, height] => {
            "its data window is not the whole picture"
        }
        _ => {
            if width != 2 * height {
                let message = format!("{}: it is {width}×{height}", path.display());
                log.warning(
                    place,
                    message,
                    "pictures of all directions are twice as wide as high: this one is stretched",
                );
            }
            return Some(picture.film);
        }
    };
    log.error(place, format!("{}: {wrong}", path.display()), "");
    None
}

const LOOKED_FOR: &str =
    "a picture is searched next to the scene file, then in the working directory";
