//! `vkpt init`: a first scene.

use std::fs;
use std::path::Path;

use super::program::{folder, names, words};

#[test]
fn a_first_scene_is_rendered_without_a_word() {
    let folder = folder("");
    let run = words(folder.path(), "init");
    let message = "note: vkpt scene.txt renders it\n";
    assert_eq!(
        (run.code, run.out.as_str(), run.err.as_str()),
        (Some(0), "", message)
    );
    let text = fs::read_to_string(folder.path().join("scene.txt")).expect("a scene");
    assert_eq!(words(folder.path(), "init -").out, text);
    let strict = "scene.txt --strict --size 40x30 --spp 1 --device cpu-f32 --quiet -o a.png";
    let run = words(folder.path(), strict);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    // Each command that takes no file has its line.
    let read = vkpt::scene::parse(&text, Path::new("scene.txt"), true).expect("no error");
    assert_eq!(
        (read.scene.shapes.len(), read.scene.materials.len()),
        (5, 5)
    );
    for command in [
        "screen",
        "camera",
        "background",
        "light",
        "brdf",
        "sphere",
        "box",
        "cylinder",
    ] {
        let at = text
            .lines()
            .position(|line| line.starts_with(command))
            .expect(command);
        let before = text.lines().take(at).collect::<Vec<_>>();
        let explained = before
            .iter()
            .rev()
            .find(|line| !line.starts_with(char::is_alphabetic));
        assert!(
            explained.is_some_and(|line| line.starts_with('#')),
            "{command}"
        );
    }
}

#[test]
fn no_file_is_written_over() {
    let folder = folder("");
    fs::write(folder.path().join("a.txt"), "mine").expect("a file");
    let before = names(folder.path());
    let run = words(folder.path(), "init a.txt");
    let message = "error: cannot write a.txt: it exists already; give the scene another name\n";
    assert_eq!((run.code, run.err.as_str()), (Some(5), message));
    assert_eq!(
        fs::read_to_string(folder.path().join("a.txt")).expect("a file"),
        "mine"
    );
    assert_eq!(words(folder.path(), "init none/a.txt").code, Some(5));
    assert_eq!(names(folder.path()), before);
}
