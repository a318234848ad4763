//! `--samples` and `vkpt merge`: parts of a picture, rendered separately and joined.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use serde_json::Value;
use tempfile::TempDir;

use super::program::{Run, folder, names, run, shown, words};

/// Few pixels, glass among them.
const SCENE: &str = "screen 6 4\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\nbrdf .5 .6 .7 0 0 0 1\n\
    box -9 -9 -2 18 18 1\nbrdf 0 0 0 .04 .04 .04 .2 .9 .5 .3 1.5\nsphere 0 0 0 .6\n";

const COMMON: &str = "--device cpu-f32 --quiet";

fn ok(folder: &TempDir, line: &str) {
    let run = words(folder.path(), line);
    assert_eq!((run.code, &*run.err), (Some(0), ""), "{line}");
}

fn refused(folder: &TempDir, line: &str, code: i32) -> String {
    let before = names(folder.path());
    let Run {
        code: ended, err, ..
    } = words(folder.path(), line);
    assert_eq!(ended, Some(code), "{line}: {err}");
    assert_eq!(names(folder.path()), before, "{line}");
    err
}

/// Parts `SAMPLES.vkpt`.
fn parts(folder: &TempDir, ranges: &[&str], more: &str) {
    for range in ranges {
        let name = range.replace("..", "-");
        ok(
            folder,
            &format!("scene.scn {COMMON} --samples {range} -o {name}.vkpt{more}"),
        );
    }
}

fn json(folder: &Path, name: &str) -> Value {
    let text = fs::read_to_string(folder.join(name)).expect("a report");
    serde_json::from_str(&text).expect("JSON")
}

/// A report without the fields that differ from run to run.
fn timeless(folder: &Path, name: &str) -> Value {
    let mut all = json(folder, name);
    let fields = all.as_object_mut().expect("an object");
    for field in ["seconds", "samples_per_s", "rays_per_s", "memory", "files"] {
        assert!(fields.remove(field).is_some(), "{field}");
    }
    for error in fields["error"].as_array_mut().expect("a list") {
        assert!(
            error
                .as_object_mut()
                .expect("an object")
                .remove("seconds")
                .is_some()
        );
    }
    all
}

/// Runs what must fail; the command and its message.
fn message(folder: &TempDir, line: &str, code: i32) -> String {
    let arguments: Vec<&str> = line.split(' ').collect();
    shown(&arguments, &refused(folder, line, code))
}

#[test]
fn parts_make_the_files_of_one_rendering() {
    for more in [
        "",
        " --integrator path",
        " --sampler random --aov stderr",
        " --crop 1,0,5,3",
    ] {
        let folder = folder(SCENE);
        let outputs = |name: &str| {
            let aov = if more.contains("--aov") {
                " --aov stderr"
            } else {
                ""
            };
            format!("--quiet -o {name}.exr -o {name}.png -o {name}.hdr --json {name}.json{aov}")
        };
        ok(
            &folder,
            &format!(
                "scene.scn --device cpu-f32 {}{more} --spp 700",
                outputs("one")
            ),
        );
        parts(
            &folder,
            &["0..100", "100..512", "512..513", "513..700"],
            more,
        );
        // In any order.
        ok(
            &folder,
            &format!(
                "merge 513-700.vkpt 0-100.vkpt 512-513.vkpt 100-512.vkpt --spp 700 {}",
                outputs("joined")
            ),
        );
        let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a file");
        for ending in [".exr", ".png", ".hdr"] {
            let [one, joined] = ["one", "joined"].map(|name| bytes(&format!("{name}{ending}")));
            assert!(one == joined, "{more}: {ending}");
        }
        if more.contains("--aov") {
            assert!(bytes("one-stderr.exr") == bytes("joined-stderr.exr"));
        }
        let [one, joined] = ["one.json", "joined.json"].map(|name| timeless(folder.path(), name));
        assert_eq!(one, joined, "{more}");
        assert!(one["error"].as_array().expect("a list").len() > 9);
    }
}

#[test]
fn larger_parts_are_made_of_parts() {
    let folder = folder(SCENE);
    parts(&folder, &["0..200", "200..300", "300..600"], "");
    ok(&folder, &format!("scene.scn {COMMON} --spp 600 -o one.exr"));
    ok(
        &folder,
        "merge 300-600.vkpt 200-300.vkpt -o later.vkpt --quiet",
    );
    ok(
        &folder,
        "merge later.vkpt 0-200.vkpt -o all.exr -o all.vkpt --quiet",
    );
    let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a file");
    assert!(bytes("one.exr") == bytes("all.exr"));
    // A joined part can be resumed.
    ok(
        &folder,
        &format!("scene.scn {COMMON} --spp 650 --resume -o all.vkpt -o more.exr"),
    );
    ok(
        &folder,
        &format!("scene.scn {COMMON} --spp 650 -o anew.exr"),
    );
    assert!(bytes("more.exr") == bytes("anew.exr"));
}

#[test]
fn missing_and_overlapping_samples_are_named() {
    let folder = folder(SCENE);
    parts(&folder, &["0..4", "4..8", "6..10", "12..14"], "");
    let lines = [
        "merge 0-4.vkpt 12-14.vkpt 6-10.vkpt -o a.exr",
        "merge 0-4.vkpt 4-8.vkpt 6-10.vkpt -o a.exr",
        "merge 4-8.vkpt 4-8.vkpt -o a.vkpt",
        "merge 4-8.vkpt -o a.exr",
        "merge 0-4.vkpt 4-8.vkpt --spp 16 -o a.exr",
        "merge 0-4.vkpt 4-8.vkpt --spp 6 -o a.exr",
    ];
    let messages = lines.map(|line| message(&folder, line, 3));
    assert_snapshot!(messages.concat());
    // The command that is named renders what is missing.
    ok(
        &folder,
        "scene.scn --device cpu-f32 --quiet --samples 4..6 --size 6x4 --integrator bidirectional -o 4-6.vkpt",
    );
    ok(
        &folder,
        "merge 0-4.vkpt 4-6.vkpt 6-10.vkpt -o a.exr --quiet",
    );
}

#[test]
fn parts_of_something_else_are_refused_by_name() {
    let folder = folder(SCENE);
    parts(&folder, &["0..2"], "");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a file");
    write("other.scn", &SCENE.replace(".6 .7", ".6 .8"));
    let others = [
        "other.scn --samples 2..4",
        "scene.scn --samples 2..4 --seed 3",
        "scene.scn --samples 2..4 --size 7x4",
        "scene.scn --samples 2..4 --crop 0,0,2,2",
        "scene.scn --samples 2..4 --max-depth 3",
        "scene.scn --samples 2..4 --sampler random",
        "scene.scn --samples 2..4 --integrator path",
    ];
    let mut messages = String::new();
    for other in others {
        ok(&folder, &format!("{other} {COMMON} -o other.vkpt"));
        messages += &format!("other.vkpt: {other}\n");
        messages += &message(&folder, "merge 0-2.vkpt other.vkpt -o a.exr", 3);
    }
    let other = "scene.scn --device cpu-f64 --quiet --samples 2..4";
    ok(&folder, &format!("{other} -o other.vkpt"));
    messages += &format!("other.vkpt: {other}\n");
    messages += &message(&folder, "merge 0-2.vkpt other.vkpt -o a.exr", 3);
    write("no.vkpt", "no part");
    messages += &message(&folder, "merge 0-2.vkpt no.vkpt none.vkpt -o a.exr", 3);
    assert_snapshot!(messages);
}

/// The bytes of a mesh count, wherever the file is.
#[test]
fn another_mesh_is_another_scene() {
    let folder = folder(super::program::MESHED);
    let mesh = folder.path().join("m.ply");
    fs::write(&mesh, super::program::MESH).expect("a mesh");
    parts(&folder, &["0..2"], "");
    fs::write(&mesh, super::program::MESH.replace("0 1 0", "0 1.5 0")).expect("a mesh");
    parts(&folder, &["2..4"], "");
    let err = refused(&folder, "merge 0-2.vkpt 2-4.vkpt -o a.exr", 3);
    assert!(
        err.contains("the scene or one of its meshes differs"),
        "{err}"
    );
}

#[test]
fn a_damaged_part_leaves_no_picture() {
    let folder = folder(SCENE);
    parts(&folder, &["0..3", "3..5"], "");
    let path = folder.path().join("3-5.vkpt");
    let whole = fs::read(&path).expect("a part");
    let mut damaged = whole.clone();
    let at = damaged.len() - 50;
    damaged[at] ^= 4;
    fs::write(&path, &damaged).expect("written");
    let err = refused(&folder, "merge 0-3.vkpt 3-5.vkpt -o a.exr --json a.json", 3);
    assert!(err.contains("3-5.vkpt: it is damaged"), "{err}");
    fs::write(&path, &whole[..whole.len() - 9]).expect("written");
    let err = refused(&folder, "merge 0-3.vkpt 3-5.vkpt -o a.exr", 3);
    assert!(err.contains("3-5.vkpt: it has"), "{err}");
}

#[test]
fn a_wrong_command_line_is_refused() {
    let folder = folder(SCENE);
    parts(&folder, &["0..2"], "");
    let lines = [
        "scene.scn --samples 0..2 -o a.exr",
        "scene.scn --samples 2..2",
        "scene.scn --samples 2",
        "scene.scn --samples 0..2 --spp 4",
        "scene.scn --samples 0..2 --target-error 1e-3",
        "scene.scn --checkpoint 0",
        "scene.scn --resume -o - --format png",
        "merge 0-2.vkpt",
        "merge 0-2.vkpt -o 0-2.vkpt",
        "merge 0-2.vkpt -o a.jpg",
        "merge",
    ];
    let messages = lines.map(|line| message(&folder, line, 2));
    assert_snapshot!(messages.concat());
}

#[test]
fn a_part_is_named_after_scene_and_samples() {
    let folder = folder(SCENE);
    ok(&folder, &format!("scene.scn {COMMON} --samples 0..2"));
    assert_eq!(names(folder.path()), ["scene-0-2.vkpt", "scene.scn"]);
    let printed = run(
        folder.path(),
        &["scene.scn", "--device", "cpu-f32", "--samples", "2..4"],
    );
    assert!(
        printed.out.contains("wrote   scene-2-4.vkpt"),
        "{}",
        printed.out
    );
}
