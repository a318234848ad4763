//! `background FILE` and `ibl FILE`: reading, warnings, and refusals.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use glam::{DQuat, DVec3};
use tempfile::TempDir;
use vkpt::scene::{Errors, Read, Scene, parse};

use crate::common::surroundings::picture;

const HEAD: &str = "screen 4 3\ncamera 0 0 5 .5\n";

/// A folder with pictures: `sky.exr` of 4 × 2 texels, `My Sky.EXR`, `square.exr`, `dark.exr` with negative values, and files
/// that are none.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let put = |name: &str, bytes: &[u8]| {
        fs::write(folder.path().join(name), bytes).expect("a file");
    };
    let bytes = |file: tempfile::NamedTempFile| fs::read(file.path()).expect("a picture");
    let sky = bytes(picture(4, 2, |x, y| [x as f32, y as f32, 1.0]));
    put("sky.exr", &sky);
    put("My Sky.EXR", &sky);
    put("square.exr", &bytes(picture(2, 2, |_, _| [1.0; 3])));
    put(
        "dark.exr",
        &bytes(picture(2, 1, |x, _| [-1.0, 0.5, -(x as f32)])),
    );
    put(
        "nan.exr",
        &bytes(picture(2, 1, |_, _| [1.0, f32::NAN, 1.0])),
    );
    put("short.exr", &sky[..100]);
    put("text.hdr", b"no picture\n");
    let mut png = std::io::Cursor::new(Vec::new());
    let film = vkpt::film::Film {
        width: 2,
        height: 1,
        rgb: vec![[0.5; 3]; 2],
    };
    let frame = vkpt::image::Frame::whole(&film);
    let labels = vkpt::image::Labels {
        exposure: 0.0,
        software: "",
        notes: &[],
    };
    vkpt::image::encode(&frame, vkpt::image::Format::Png, &labels, &mut png).expect("a PNG");
    put("low.png", png.get_ref());
    folder
}

fn read(folder: &Path, lines: &str) -> Result<Read, Errors> {
    parse(
        &format!("{HEAD}{lines}\n"),
        &folder.join("scene.scn"),
        false,
    )
}

fn good(folder: &Path, lines: &str) -> Scene {
    let read = read(folder, lines).unwrap_or_else(|e| panic!("{lines}: {:?}", e.diagnostics));
    assert!(read.warnings.is_empty(), "{lines}: {:?}", read.warnings);
    read.scene
}

#[test]
fn a_picture_stands_all_around() {
    let folder = folder();
    let folder = folder.path();
    for (line, scale, rotate) in [
        ("background sky.exr", 1.0, DQuat::IDENTITY),
        ("background sky.exr 2.5", 2.5, DQuat::IDENTITY),
        (
            "background sky.exr z 90",
            1.0,
            DQuat::from_rotation_z(90f64.to_radians()),
        ),
        (
            "ibl sky.exr .5 x 90 q 1 0 0 1",
            0.5,
            DQuat::from_rotation_x(90f64.to_radians()) * DQuat::from_rotation_z(90f64.to_radians()),
        ),
    ] {
        let scene = good(folder, line);
        let surroundings = scene.surroundings.expect(line);
        assert_eq!(surroundings.path, folder.join("sky.exr"));
        assert_eq!(surroundings.scale, scale, "{line}");
        assert!(surroundings.rotate.angle_between(rotate) < 1e-12, "{line}");
        let film = surroundings.picture;
        assert_eq!((film.width, film.height), (4, 2));
        assert_eq!(film.rgb[6], [2.0, 1.0, 1.0]);
        assert_eq!((scene.background, scene.background_line), (DVec3::ZERO, 3));
    }
}

#[test]
fn the_last_background_counts() {
    let folder = folder();
    let both = "background sky.exr\nbackground 1 2 3";
    let read = read(folder.path(), both).expect("a scene");
    assert!(read.scene.surroundings.is_none());
    assert_eq!(read.scene.background, DVec3::new(1.0, 2.0, 3.0));
    let messages: Vec<String> = read.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(messages, ["`background` is given more than once"]);
}

/// As other programs of the course have it: the sphere about the eye carries the picture, and is no shape here.
#[test]
fn the_sphere_that_carries_a_picture_is_no_shape() {
    let folder = folder();
    let count = |lines: &str| good(folder.path(), lines).shapes.len();
    assert_eq!(count("ibl sky.exr\nsphere 0 0 0 1000"), 0);
    assert_eq!(
        count("ibl sky.exr\nsphere 0 0 0 1000\nbrdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1"),
        1
    );
    assert_eq!(
        count("ibl sky.exr\nbrdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1000"),
        1
    );
    // The eye, which comes before or after, is not in this one.
    assert_eq!(count("ibl sky.exr\nsphere 0 0 0 1"), 1);
    assert_eq!(count("sphere 0 0 0 1000\nibl sky.exr"), 1);
    assert_eq!(count("background sky.exr\nsphere 0 0 0 1000"), 1);
}

#[test]
fn names_are_read_as_meshes_are() {
    let folder = folder();
    for (line, message) in [
        ("background My Sky.EXR 2", "a blank ends a name"),
        (
            "background \"My Sky.EXR\" 2",
            "no file has exactly this name",
        ),
        ("background SKY.exr 2", "no file has exactly this name"),
    ] {
        let read = read(folder.path(), line).expect(line);
        assert_eq!(read.scene.surroundings.expect(line).scale, 2.0, "{line}");
        assert_eq!(read.warnings.len(), 1, "{line}");
        let labels = miette::Diagnostic::labels(&read.warnings[0]);
        let label = labels
            .and_then(|mut labels| labels.next())
            .expect("a label");
        assert_eq!(label.label(), Some(message), "{line}");
    }
}

#[test]
fn oddities_of_a_picture_give_warnings() {
    let folder = folder();
    for (line, message) in [
        ("background square.exr", "it is 2×2"),
        ("background dark.exr", "3 of its values are negative"),
    ] {
        let read = read(folder.path(), line).expect(line);
        assert_eq!(read.warnings.len(), 1, "{line}");
        let warning = read.warnings[0].to_string();
        assert!(warning.ends_with(message), "{line}: {warning}");
        let film = Arc::clone(&read.scene.surroundings.expect(line).picture);
        assert!(film.rgb.as_flattened().iter().all(|x| *x >= 0.0));
    }
}

#[test]
fn files_that_are_no_pictures_of_radiances_are_refused() {
    let folder = folder();
    for (line, message) in [
        ("background gone.exr", "no such file"),
        ("background sky.jpg", "no such file"),
        ("ibl", "`ibl` has too few arguments"),
        (
            "background low.png",
            "a PNG has no radiances: use an EXR (.exr) or HDR (.hdr) for surroundings",
        ),
        (
            "background text.hdr",
            "is not a picture in a supported format: EXR, HDR or PNG",
        ),
        (
            "background nan.exr",
            "2 of its values are NaN or infinite; the first is NaN in pixel 0,0 from the top left, channel G",
        ),
        ("background sky.exr 0", "the scale must be above 0"),
        ("background sky.exr -1", "the scale must be above 0"),
        (
            "background sky.exr 1 z",
            "`background` has too few arguments",
        ),
        ("background red 1 1", "`red` is not a number"),
        ("background 1 1", "`background` has too few arguments"),
    ] {
        let errors = read(folder.path(), line).expect_err(line).diagnostics;
        let errors: Vec<String> = errors.iter().map(ToString::to_string).collect();
        assert_eq!(errors.len(), 1, "{line}: {errors:?}");
        assert!(errors[0].ends_with(message), "{line}: {errors:?}");
    }
    let short = read(folder.path(), "background short.exr").expect_err("too short");
    assert_eq!(short.diagnostics.len(), 1);
}
