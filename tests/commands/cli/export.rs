//! `vkpt export`: the files that it leaves, and how it ends.

use std::fs;

use roxmltree::Document;

use super::program::{SCENE, folder, names, run};
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
    // What cannot be written is found before anything is.
    fs::create_dir(folder.path().join("out/b-6.ply")).expect("a folder");
    let refused = export("out/b.xml");
    assert_eq!(refused.code, Some(5), "{}", refused.err);
    assert_eq!(
        names(&folder.path().join("out")),
        ["a-6.ply", "a.xml", "b-6.ply"]
    );
}

#[test]
fn what_has_no_equal_is_told_by_file_and_line_and_leaves_nothing() {
    let folder = folder(&format!(
        "{SCENE}brdf .1 .1 .1 .5 .5 .5 60\nsphere 3 0 0 1\n"
    ));
    let refused = run(folder.path(), &TO);
    assert_eq!((refused.code, refused.out.as_str()), (Some(3), ""));
    assert!(
        refused.err.starts_with("error: scene.scn:5: Kd beside Ks"),
        "{}",
        refused.err
    );
    assert_eq!(names(folder.path()), ["scene.scn"]);
}

#[test]
fn a_flag_without_an_equal_is_a_mistake_of_the_command_line() {
    let folder = folder(SCENE);
    for (flags, said) in [
        (&["--model", "handout"][..], "--absorption term"),
        (&["--radiance-scaling", "off"], "--radiance-scaling off"),
        (&["--crop", "0,0,9,6"], "outside the picture of 8x6"),
    ] {
        let refused = run(folder.path(), &[&TO, flags].concat());
        assert_eq!(refused.code, Some(2), "{}", refused.err);
        assert!(refused.err.contains(said), "{}", refused.err);
    }
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
