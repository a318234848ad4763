//! glTF files as scenes, by the program.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use serde_json::json;
use tempfile::TempDir;

use super::program::{Run, names, words};
use super::rendering::read_exr;
use crate::common::models::{Model, glass, lamp, matte};

/// A block of glass and a lamp, as `model.glb`.
fn folder(model: &Model) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("model.glb"), model.glb()).expect("a file");
    folder
}

fn model() -> Model {
    let mut model = Model::seen_from([0.0, 0.5, 5.0], 0.5);
    model.cuboid([-1.0; 3], [1.0, 0.5, 0.75], glass([0.5, 0.75, 0.25], 1.0));
    model
}

fn rendered(folder: &Path, line: &str) -> Run {
    let run = words(folder, line);
    assert_eq!(run.code, Some(0), "{line}: {}", run.err);
    run
}

/// All primitives of one material are one mesh in a scene file, and all numbers here are the same in both.
#[test]
fn the_same_scene_as_text_makes_the_same_bits() {
    for (material, text) in [
        (
            glass([0.5, 0.75, 0.25], 1.0),
            format!(
                "brdf 0 0 0  {0} {0} {0}  0  .5 .75 .25  1.5",
                0.2f64.powi(2)
            ),
        ),
        (
            matte([0.5, 0.25, 0.75]),
            "brdf .5 .25 .75  0 0 0  1".to_owned(),
        ),
        (lamp(4.0), "light 4 4 4".to_owned()),
    ] {
        let mut model = Model::seen_from([0.0, 0.5, 5.0], 0.5);
        model.cuboid([-1.0; 3], [1.0, 0.5, 0.75], material);
        let folder = folder(&model);
        let background = if text.starts_with("light") {
            ""
        } else {
            "background 1 1 1\n"
        };
        let ry = 0.5f64.atan().tan();
        let scene = format!(
            "screen 24 24\ncamera 0 .5 5  {ry}\n{background}{text}\nmesh model.glb  0 0 0  1\n"
        );
        fs::write(folder.path().join("scene.scn"), scene).expect("a file");
        let options = "--size 24x24 --spp 8 --device cpu-f32 --quiet";
        rendered(folder.path(), &format!("model.glb {options} -o a.exr"));
        rendered(folder.path(), &format!("scene.scn {options} -o b.exr"));
        let [a, b] = ["a.exr", "b.exr"].map(|name| read_exr(&folder.path().join(name)).rgb);
        assert!(a.iter().flatten().any(|x| *x > 0.0));
        assert_eq!(a, b, "{text}");
    }
}

/// In a file of three things all commands find the lines that they name.
#[test]
fn every_command_takes_it() {
    let folder = folder(&model());
    let rendering = "--size 6x6 --device cpu-f32";
    let run = rendered(folder.path(), "explain model.glb");
    assert!(
        run.out
            .contains("mesh node 1, mesh 0, primitive 0 # material 0"),
        "{}",
        run.out
    );
    let run = rendered(
        folder.path(),
        &format!("model.glb {rendering} --trace 3,3,0"),
    );
    assert!(run.out.contains("\nline 7 is `mesh node 1,"), "{}", run.out);
    rendered(
        folder.path(),
        &format!("converge model.glb {rendering} --spp 4 --time=1"),
    );
    rendered(
        folder.path(),
        &format!("model.glb {rendering} --samples 0..2 -o a.vkpt"),
    );
    rendered(
        folder.path(),
        &format!("model.glb {rendering} --samples 2..4 --camera Eye -o b.vkpt"),
    );
    rendered(folder.path(), "merge a.vkpt b.vkpt -o c.exr");
    rendered(
        folder.path(),
        "export model.glb --to mitsuba --fresnel exact",
    );
    let run = words(folder.path(), "export model.glb --to mitsuba -o d.xml");
    let place = "error: model.glb, `brdf 0 0 0 ";
    assert!(
        run.code == Some(3) && run.err.contains(place),
        "{}",
        run.err
    );
    rendered(folder.path(), "farm slurm model.glb --camera Eye --spp 4");
}

#[test]
fn a_camera_that_is_not_there_is_an_error_that_lists_them() {
    let folder = folder(&model());
    let run = words(folder.path(), "model.glb --camera Back --quiet");
    assert_eq!(run.code, Some(3));
    assert_eq!(names(folder.path()), ["model.glb"]);
    assert_snapshot!(run.err);
}

/// A buffer next to the file is a part of the scene: a part rendered with another buffer is not resumed.
#[test]
fn parts_of_other_buffers_or_cameras_do_not_join() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let mut model = model();
    let camera = json!({"camera": 0, "translation": [0, 0, 9], "name": "Far"});
    model.add_node(camera);
    let gltf = model.whole(Some("model.bin")).to_string();
    fs::write(at("model.gltf"), gltf).expect("a file");
    fs::write(at("model.bin"), model.bytes()).expect("a file");
    let part = |range: &str, more: &str| {
        let line =
            format!("model.gltf --size 4x4 --device cpu-f32 --quiet --samples {range} {more}");
        rendered(folder.path(), line.trim_end());
    };
    part("0..1", "-o a.vkpt");
    part("1..2", "-o b.vkpt");
    part("1..2", "-o far.vkpt --camera Far");
    let mut bytes = model.bytes().to_vec();
    // The exponent of the first coordinate.
    bytes[3] ^= 1;
    fs::write(at("model.bin"), bytes).expect("a file");
    part("1..2", "-o moved.vkpt");
    let merged = |other: &str| words(folder.path(), &format!("merge a.vkpt {other} -o c.exr")).code;
    assert_eq!(merged("b.vkpt"), Some(0));
    assert_eq!(merged("far.vkpt"), Some(3));
    assert_eq!(merged("moved.vkpt"), Some(3));
}

/// Notes are for people, warnings for scripts too.
#[test]
fn a_quiet_run_prints_warnings_only() {
    let mut dim = model();
    let folder = folder(&dim);
    let quiet = "model.glb --size 4x4 --spp 1 --device cpu-f32 --quiet -o a.exr";
    assert_eq!(rendered(folder.path(), quiet).err, "");
    assert_eq!(
        rendered(folder.path(), &format!("{quiet} --strict")).err,
        ""
    );
    dim.document["materials"][0]["normalTexture"] = json!({"index": 0});
    fs::write(folder.path().join("model.glb"), dim.glb()).expect("a file");
    assert!(rendered(folder.path(), quiet).err.contains("normalTexture"));
    let run = words(folder.path(), &format!("{quiet} --strict"));
    assert_eq!(run.code, Some(3), "{}", run.err);
}
