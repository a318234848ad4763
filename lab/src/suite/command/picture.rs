//! A scene's picture: rendered, read, compared, written.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::arguments::TestArguments;
use crate::cli::destination::Written;
use crate::cli::exit::Failure;
use crate::cli::job::Ready;
use crate::cli::source::Source;
use vkpt::film::Film;
use vkpt::image::file::write_whole;
use vkpt::image::{Format, Frame, Labels, Picture, decode, encode, read};
use vkpt::metrics::{Errors, Pair, heatmap};
use vkpt::render::{End, Progress, render};
use vkpt::report::{self, SOFTWARE, differences};

/// The bytes of an EXR, and the picture that they decode to.
pub struct Rendered {
    pub bytes: Vec<u8>,
    pub picture: Picture,
}

/// Renders a scene; `None` if a signal ended it.
pub fn rendered(
    arguments: &TestArguments,
    scene: &Path,
    name: &str,
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Option<Rendered>, Failure> {
    let source = Source::File(scene.to_owned());
    let request = arguments.request(&source);
    let ready = Ready::new(&request)?;
    let job = ready.job(&request)?;
    let outcome = render(&job, &arguments.device, stop, progress).map_err(Failure::Render)?;
    match outcome.end {
        End::Interrupted => return Ok(None),
        End::Lost => {
            return Err(Failure::Lost {
                why: outcome.failure.unwrap_or_default(),
                part: None,
            });
        }
        End::Complete | End::Time | End::Error => {}
    }
    let camera = &ready.prepared.camera;
    let full = [camera.width, camera.height];
    // Only the name: the file does not depend on the place of the folder.
    let record = report::Job {
        scene: name.to_owned(),
        camera: request.camera.map(str::to_owned),
        size: full,
        crop: request.crop,
        range: None,
        spp: outcome.spp,
        spp_asked: request.spp,
        ended: "complete".into(),
        time: None,
        target_error: None,
        seed: request.seed,
        settings: (&ready.settings).into(),
        auto: ready.why.map(Into::into),
    };
    let [x0, y0, ..] = request.crop.unwrap_or_default();
    let frame = Frame {
        film: &outcome.film,
        origin: [x0, y0],
        full,
        channels: &[],
    };
    let notes = report::notes(&record, &outcome.stats.device);
    let bytes = encoded(&frame, Format::Exr, &notes)?;
    let picture = decode(&bytes).map_err(|error| Failure::Pictures(vec![error.to_string()]))?;
    Ok(Some(Rendered { bytes, picture }))
}

/// How a picture differs from the expected one, and the relMSE if their sizes are equal; `None` if all bits are equal.
pub fn difference(actual: &Picture, expected: &Picture) -> Option<(Option<f64>, String)> {
    if (actual.full, actual.origin) != (expected.full, expected.origin)
        || [actual.film.width, actual.film.height] != [expected.film.width, expected.film.height]
    {
        let of = |p: &Picture| {
            format!(
                "{}×{} pixels at {},{} of {}×{}",
                p.film.width, p.film.height, p.origin[0], p.origin[1], p.full[0], p.full[1]
            )
        };
        let words = format!("it has {}; expected {}", of(actual), of(expected));
        return Some((None, words + &made_from(actual, expected)));
    }
    let bits = |rgb: [f32; 3]| rgb.map(f32::to_bits);
    let pixels = actual.film.rgb.iter().zip(&expected.film.rgb);
    let differs: Vec<usize> = (pixels.enumerate())
        .filter(|(_, (a, b))| bits(**a) != bits(**b))
        .map(|(i, _)| i)
        .collect();
    let &first = differs.first()?;
    let rel_mse = match Pair::new(&actual.film, &expected.film) {
        Ok(pair) => Errors::of(&pair).rel_mse.all,
        Err(error) => return Some((None, error.to_string())),
    };
    let width = actual.film.width as usize;
    let words = format!(
        "relMSE {rel_mse:.2e}; {} of {} pixels differ, the first at {},{}",
        differs.len(),
        actual.film.rgb.len(),
        first % width,
        first / width
    );
    Some((Some(rel_mse), words + &made_from(actual, expected)))
}

/// The differences in how they were made, a line each.
fn made_from(actual: &Picture, expected: &Picture) -> String {
    let all = differences(&expected.notes, &actual.notes).unwrap_or_default();
    let names = ["the kept picture", "this one"];
    all.iter()
        .map(|each| format!("\n{}", each.between(names)))
        .collect()
}

/// The relative squared error of each pixel as a colour.
pub fn heat(actual: &Picture, expected: &Picture) -> Option<Film> {
    let pair = Pair::new(&actual.film, &expected.film).ok()?;
    Some(heatmap(&pair))
}

/// A picture of `film` alone.
pub fn png(film: &Film) -> Result<Vec<u8>, Failure> {
    encoded(&Frame::whole(film), Format::Png, &[])
}

fn encoded(
    frame: &Frame,
    format: Format,
    notes: &[(&'static str, String)],
) -> Result<Vec<u8>, Failure> {
    let labels = Labels {
        exposure: 0.0,
        software: SOFTWARE,
        notes,
    };
    let mut bytes = std::io::Cursor::new(Vec::new());
    let written = encode(frame, format, &labels, &mut bytes);
    written.map_err(|error| Failure::Pictures(vec![error.to_string()]))?;
    Ok(bytes.into_inner())
}

/// Reads the expected picture; `None` if it does not exist.
pub fn expected(path: &Path) -> Result<Option<Picture>, Failure> {
    match path.exists() {
        true => read(path)
            .map(Some)
            .map_err(|error| Failure::Pictures(vec![error.to_string()])),
        false => Ok(None),
    }
}

/// Writes bytes whole or not at all.
pub fn put(path: &Path, bytes: &[u8]) -> Written {
    write_whole(path, |out| out.write_all(bytes))
}
