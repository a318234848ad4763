//! A rendering in its own folder: how it ended and which files it left.

use std::fmt;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use vkpt::image::read;

use super::layer::Layer;
use crate::cli::program;

/// A lamp and surfaces that it lights: noise, so that no two numbers of samples make one picture.
const SCENE: &str = "screen 32 24\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

/// A hundred times the time of a rendering.
const LIMIT: Duration = Duration::from_secs(60);

/// The old file at the picture's path.
const OLD: &[u8] = b"old";

/// The state of the picture afterwards.
#[derive(Clone, Debug, PartialEq)]
pub enum Left {
    Old,
    Nothing,
    /// A picture of the scene's size, by the bits of its pixels.
    Whole(Vec<u32>),
    Broken(String),
}

pub struct Trial {
    /// None after a signal.
    pub code: Option<i32>,
    pub hung: bool,
    pub err: String,
    pub picture: Left,
    /// Whether the report is whole, or none.
    pub report: Result<bool, String>,
    /// The folder's other files.
    pub others: Vec<String>,
    /// The picture after cpu-f32 resumes the rendering from the files left.
    pub resumed: Option<Left>,
}

impl fmt::Display for Trial {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let picture = match &self.picture {
            Left::Whole(_) => "a whole picture".to_owned(),
            other => format!("{other:?}"),
        };
        let Self {
            code,
            report,
            others,
            err,
            ..
        } = self;
        write!(
            f,
            "exit code {code:?}, {picture}, report {report:?}, {others:?}\n{err}"
        )
    }
}

/// The program under the layer, which renders to `a.exr` and `a.json`.
pub fn command(layer: &Layer, folder: &Path) -> Command {
    let line = "scene.scn --device llvmpipe --spp 64 --quiet -o a.exr --json a.json";
    let mut command = program::command(folder, &line.split(' ').collect::<Vec<_>>());
    layer.load(&mut command);
    command
}

/// The same with a fault, in the layer's words.
pub fn rendering(layer: &Layer, fault: &str) -> Trial {
    finish(|folder| {
        let mut command = command(layer, folder);
        command.env("VKPT_FAULT", fault);
        command
    })
}

/// Runs the command that `start` makes for a folder with the scene and an old picture.
pub fn finish(start: impl FnOnce(&Path) -> Command) -> Trial {
    finish_within(LIMIT, start)
}

/// At most so long.
pub fn finish_within(limit: Duration, start: impl FnOnce(&Path) -> Command) -> Trial {
    let folder = program::folder(SCENE);
    let path = |name: &str| folder.path().join(name);
    let errors = tempfile::NamedTempFile::new().expect("a file");
    fs::write(path("a.exr"), OLD).expect("a file");
    let child = start(folder.path())
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(File::create(errors.path()).expect("a file"))
        .spawn()
        .expect("it runs");
    let code = wait(child, limit);
    let mut others = program::names(folder.path());
    others.retain(|name| !["scene.scn", "a.exr", "a.json"].contains(&name.as_str()));
    let (left, report) = (picture(&path("a.exr")), report(&path("a.json")));
    let resumed = path("a.vkpt").exists().then(|| {
        let line = "scene.scn --device cpu-f32 --spp 64 --quiet -o a.exr --resume";
        program::words(folder.path(), line);
        picture(&path("a.exr"))
    });
    Trial {
        code: code.flatten(),
        hung: code.is_none(),
        err: String::from_utf8_lossy(&fs::read(errors.path()).expect("a file")).into_owned(),
        picture: left,
        report,
        others,
        resumed,
    }
}

/// The exit code, `Some(None)` after a signal; `None` where it did not end in time, and was killed.
fn wait(mut child: Child, limit: Duration) -> Option<Option<i32>> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().expect("a child") {
            return Some(status.code());
        }
        if start.elapsed() > limit {
            child.kill().and_then(|()| child.wait()).expect("killed");
            return None;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn picture(path: &Path) -> Left {
    match fs::read(path) {
        Err(_) => Left::Nothing,
        Ok(bytes) if bytes == OLD => Left::Old,
        Ok(_) => match read(path) {
            Ok(picture) if picture.full == [32, 24] && picture.film.rgb.len() == 32 * 24 => {
                let numbers = picture.film.rgb.as_flattened();
                Left::Whole(numbers.iter().map(|x| x.to_bits()).collect())
            }
            Ok(picture) => Left::Broken(format!("a picture of {:?}", picture.full)),
            Err(error) => Left::Broken(error.to_string()),
        },
    }
}

fn report(path: &Path) -> Result<bool, String> {
    let Ok(text) = fs::read_to_string(path) else {
        return Ok(false);
    };
    let json = serde_json::from_str::<serde_json::Value>(&text);
    json.map(|_| true).map_err(|error| error.to_string())
}
