//! `vkpt export`: the files that it leaves, and how it ends.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use roxmltree::Document;

use super::program::{SCENE, folder, names, run, shown, words};
use crate::common::meshes::cube;

const TO: [&str; 4] = ["export", "scene.scn", "--to", "mitsuba"];

#[test]
fn the_scene_is_written_under_its_name_or_another() {
    let folder = folder(SCENE);
    let export = |more: &[&str]| run(folder.path(), &[&TO, more].concat());
    for more in [&[][..], &["-o", "other.xml"]] {
        let run = export(more);
        assert_eq!(
            (run.code, run.out.as_str(), run.err.as_str()),
            (Some(0), "", "")
        );
    }
    assert_eq!(
        names(folder.path()),
        ["other.xml", "scene.scn", "scene.xml"]
    );
    let text = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a text");
    assert_eq!(text("scene.xml"), text("other.xml"));
    assert!(Document::parse(&text("scene.xml")).is_ok());
    let stdout = export(&["-o", "-"]);
    assert_eq!(stdout.out, text("scene.xml"));
}

#[test]
fn meshes_stand_beside_the_scene() {
    let mesh = cube();
    let mesh = mesh.path().display();
    let folder = folder(&format!(
        "{SCENE}brdf .5 .5 .5 0 0 0 1\nmesh {mesh} 3 0 0 1\n"
    ));
    fs::create_dir(folder.path().join("out")).expect("a folder");
    let export = |to: &str| run(folder.path(), &[&TO[..], &["-o", to]].concat());
    assert_eq!(export("out/a.xml").code, Some(0));
    assert_eq!(names(&folder.path().join("out")), ["a-6.ply", "a.xml"]);
    let stdout = export("-");
    assert_eq!((stdout.code, stdout.out.as_str()), (Some(2), ""));
    assert!(stdout.err.contains("use -o FILE"), "{}", stdout.err);
    // A scene that cannot be written is refused before anything is written.
    fs::create_dir(folder.path().join("out/b-6.ply")).expect("a folder");
    let refused = export("out/b.xml");
    assert_eq!(refused.code, Some(5), "{}", refused.err);
    assert_eq!(
        names(&folder.path().join("out")),
        ["a-6.ply", "a.xml", "b-6.ply"]
    );
}

#[test]
fn settings_without_an_equal_are_named_by_file_and_line_and_leave_nothing() {
    let folder = folder(&format!(
        "{SCENE}brdf .1 .1 .1 .5 .5 .5 60\nsphere 3 0 0 1\n"
    ));
    let refused = run(folder.path(), &TO);
    assert_eq!((refused.code, refused.out.as_str()), (Some(3), ""));
    assert!(
        refused.err.starts_with("error: scene.scn:5: Kd with Ks"),
        "{}",
        refused.err
    );
    assert_eq!(names(folder.path()), ["scene.scn"]);
}

#[test]
fn a_flag_without_an_equal_is_a_mistake_of_the_command_line() {
    let folder = folder(SCENE);
    let lines = [
        "--model handout",
        "--radiance-scaling off",
        "--crop 0,0,9,6",
    ];
    let messages = lines.map(|line| {
        let arguments = [&TO[..], &line.split(' ').collect::<Vec<_>>()].concat();
        let refused = run(folder.path(), &arguments);
        assert_eq!(refused.code, Some(2), "{}", refused.err);
        shown(&arguments, &refused.err)
    });
    assert_snapshot!(messages.concat());
    assert_eq!(
        run(folder.path(), &TO[..2]).code,
        Some(2),
        "--to is missing"
    );
    assert_eq!(names(folder.path()), ["scene.scn"]);
}

#[test]
fn a_detail_is_a_part_of_the_same_film() {
    let folder = folder(SCENE);
    let flags = ["--size", "80x60", "--crop", "10,20,30,50", "-o", "-"];
    let export = run(folder.path(), &[&TO[..], &flags].concat());
    let document = Document::parse(&export.out).expect("well-formed XML");
    let film = document
        .descendants()
        .find(|node| node.has_tag_name("film"));
    let film = film.expect("a film");
    for (name, value) in [
        ("width", "80"),
        ("height", "60"),
        ("crop_offset_x", "10"),
        ("crop_offset_y", "20"),
        ("crop_width", "20"),
        ("crop_height", "30"),
    ] {
        let mut named = film
            .children()
            .filter(|n| n.attribute("name") == Some(name));
        let given = named.next().and_then(|n| n.attribute("value"));
        assert_eq!(given, Some(value), "{name}");
    }
}

#[test]
fn a_detail_is_bounds_of_columns_then_rows_in_pbrt() {
    let folder = folder(SCENE);
    let flags = "--size 80x60 --crop 10,20,30,50 -o -";
    let export = words(
        folder.path(),
        &format!("export scene.scn --to pbrt {flags}"),
    );
    let bounds = "\"integer pixelbounds\" [ 10 30 20 50 ]";
    assert!(export.out.contains(bounds), "{}", export.out);
    let refused = words(
        folder.path(),
        &format!("export scene.scn --to gltf {flags}"),
    );
    assert_eq!((refused.code, refused.out.as_str()), (Some(2), ""));
    assert_snapshot!(refused.err);
}

#[test]
fn each_renderer_has_files_of_its_own() {
    let folder = folder(&SCENE.replace("sphere 0 0 0 1", "box 0 0 0 1 1 1"));
    for (to, file) in [
        ("pbrt", "scene.pbrt"),
        ("gltf", "scene.glb"),
        ("gltf -o a.gltf", "a.gltf"),
    ] {
        let run = words(folder.path(), &format!("export scene.scn --to {to}"));
        assert_eq!((run.code, run.out.as_str()), (Some(0), ""), "{}", run.err);
        assert!(folder.path().join(file).exists(), "{file}");
    }
    let left = ["a.bin", "a.gltf", "scene.glb", "scene.pbrt", "scene.scn"];
    assert_eq!(names(folder.path()), left);
    for file in ["a.gltf", "scene.glb"] {
        let read = words(folder.path(), &format!("explain {file} --strict"));
        assert_eq!(read.code, Some(0), "{}", read.err);
    }
}

#[test]
fn differences_of_models_are_warnings_and_errors_with_strict() {
    let folder = folder(&SCENE.replace("light 1 1 1", "light 3 2 1"));
    let line = "export scene.scn --to pbrt -o -";
    let warned = words(folder.path(), line);
    assert_eq!(warned.code, Some(0));
    assert!(warned.out.contains("WorldBegin"));
    let strict = words(folder.path(), &format!("{line} --strict"));
    assert_eq!((strict.code, strict.out.as_str()), (Some(3), ""));
    assert_snapshot!(warned.err + &strict.err);
}

#[test]
fn a_gltf_file_renders_to_the_bits_of_its_scene() {
    let mesh = cube();
    let mesh = mesh.path().display();
    let scene = |kt: &str| {
        format!(
            "screen 16 12\ncamera 0 0 8 .3\nlight 4 3 2\nmesh {mesh} 2 2 0 .5\nbrdf .5 .25 .75 0 0 0 1\n\
             mesh {mesh} -1 0 0 .5\nbrdf 0 0 0 .0625 .125 .25 .25  {kt} .5 1  1.5\nmesh {mesh} 1 0 1 .5\n"
        )
    };
    let folder = folder(&scene(".75"));
    fs::write(folder.path().join("other.scn"), scene(".7500001")).expect("a scene");
    let exported = words(folder.path(), "export scene.scn --to gltf");
    assert_eq!(exported.code, Some(0));
    // glTF has the aspect ratio of a picture, and not its size.
    let message = "note: scene.scn:2: glTF does not store the size in pixels: render the file with --size 16x12";
    assert_eq!(exported.err.trim_end(), message);
    let picture = |name: &str| {
        let flags = "--quiet --size 16x12 --spp 4 --device cpu-f32 -o a.exr";
        let run = words(folder.path(), &format!("{name} {flags}"));
        assert_eq!(run.code, Some(0), "{}", run.err);
        pixels(&folder.path().join("a.exr"))
    };
    let bits = picture("scene.scn");
    assert!(picture("scene.glb") == bits);
    assert!(
        picture("other.scn") != bits,
        "a wrong Kt would go unnoticed"
    );
}

fn pixels(path: &Path) -> Vec<[u32; 3]> {
    let picture = vkpt::image::read(path).expect("a picture");
    let rgb = picture.film.rgb.iter();
    rgb.map(|pixel| pixel.map(f32::to_bits)).collect()
}
