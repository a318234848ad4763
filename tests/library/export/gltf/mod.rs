//! Scenes as glTF: read back by vkpt's own reader, they are the same; and scenes that glTF cannot express are refused.

mod refusals;
mod round_trip;

use std::io::Cursor;
use std::path::Path;

use vkpt::prepared::{Prepared, prepare};
use vkpt::scene::{Scene, parse, read_from};
use vkpt::settings::Settings;
use vkpt_cli::export::Remark;
use vkpt_cli::export::gltf::{Container, Reason, export as gltf};

use super::{exported, written};

fn glb(text: &str, settings: &Settings) -> Result<Vec<u8>, Vec<Remark<Reason>>> {
    let export = exported(text, settings, |subject| gltf(subject, Container::Glb))?;
    assert!(export.beside.is_empty() && export.warnings.is_empty());
    Ok(written(&export))
}

/// A scene, ready to be rendered.
fn ready(scene: &Scene) -> Prepared {
    prepare(scene, &Settings::default(), None).expect("a scene that can be prepared")
}

/// The scene of a text, and the scene that its export is read as: without a warning.
fn there_and_back(text: &str) -> [Scene; 2] {
    let there = parse(text, Path::new("scene.scn"), false).expect("a scene");
    let bytes = glb(text, &Settings::default()).expect("nothing is refused");
    let back = read_from(Cursor::new(bytes), Path::new("a.glb"), true, None);
    [there.scene, back.expect("glTF without a warning").scene]
}
