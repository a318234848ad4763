//! Nothing that is read is written over.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;

use insta::assert_snapshot;

use super::program::{MESH, MESHED, SCENE, folder, names, shell, shown, words};

const RENDER: &str = "scene.scn --device cpu-f32 --spp 2 --quiet";

/// Every file in a folder, with its content.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let files = names(folder)
        .into_iter()
        .map(|name| (folder.join(&name), name));
    let files = files.filter(|(path, _)| path.is_file());
    files
        .map(|(path, name)| (name, fs::read(path).expect("a file")))
        .collect()
}

/// By every name that leads to it; nothing is touched.
#[test]
fn nothing_that_is_read_is_written_over() {
    let folder = folder(&MESHED.replace("m.ply", "in/m.ply"));
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("in")).expect("a folder");
    fs::write(path("in/m.ply"), MESH).expect("a mesh");
    fs::copy(path("scene.scn"), path("as.png")).expect("a scene");
    fs::copy(path("scene.scn"), path("as-stderr.exr")).expect("a scene");
    fs::hard_link(path("scene.scn"), path("hard.exr")).expect("a link");
    symlink("scene.scn", path("soft.exr")).expect("a link");
    for seed in [1, 2] {
        let line = format!("{RENDER} --seed {seed} --aov stderr -o {seed}.exr -o {seed}.png");
        assert_eq!(words(folder.path(), &line).code, Some(0));
    }
    fs::copy(path("1.exr"), path("in/sky.exr")).expect("a picture");
    let sky = "screen 4 3\ncamera 0 0 5 .5\nbackground in/sky.exr\n";
    fs::write(path("sky.scn"), sky).expect("a scene");
    let by = "--device cpu-f32 --spp 4294967295";
    let lines = [
        format!("scene.scn {by} --json scene.scn"),
        format!("scene.scn {by} --json in/../scene.scn"),
        format!("scene.scn {by} -o hard.exr"),
        format!("soft.exr {by} -o hard.exr"),
        format!("scene.scn {by} -o a.png -o soft.exr"),
        format!("as.png {by}"),
        format!("as-stderr.exr {by} -o as.exr --aov stderr"),
        format!("scene.scn {by} --json in/m.ply"),
        format!("sky.scn {by} -o in/sky.exr"),
        format!("- {by} --json scene.scn"),
        format!("converge scene.scn {by} --svg scene.scn"),
        format!("converge scene.scn {by} --reference 1.exr --csv 1.exr"),
        format!("converge scene.scn {by} --reference 1.exr --csv 1-stderr.exr"),
        "compare 1.png 2.png --heatmap 1.png".to_owned(),
        "explain scene.scn --spirv in/m.ply".to_owned(),
        "export scene.scn --to mitsuba -o scene.scn".to_owned(),
    ];
    let before = [folder.path(), &path("in")].map(contents);
    let mut messages = String::new();
    for line in lines {
        let ran = shell(folder.path(), &format!("$VKPT {line} < scene.scn"));
        assert_eq!(ran.code, Some(2), "{line}: {}", ran.err);
        messages += &shown(&line.split(' ').collect::<Vec<_>>(), &ran.err);
        let after = [folder.path(), &path("in")].map(contents);
        assert!(before == after, "{line}");
    }
    assert_snapshot!(messages);
}

/// Nor is a reference that an earlier run has left in the cache.
#[test]
fn a_kept_reference_is_not_written_over() {
    let folder = folder(SCENE);
    let converge = "VKPT_CACHE=cache $VKPT converge scene.scn --device cpu-f32 --spp 1 --time 0.05";
    let first = shell(folder.path(), &format!("{converge} --quiet"));
    assert_eq!((first.code, first.err.as_str()), (Some(0), ""));
    let kept = folder.path().join("cache/references");
    let before = contents(&kept);
    assert_eq!(before.len(), 1);
    let to = format!("cache/references/{}", before[0].0);
    let ran = shell(folder.path(), &format!("{converge} --csv {to}"));
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    let message = format!("error: {to} would be overwritten: it is a cached reference; ");
    assert!(ran.err.starts_with(&message), "{}", ran.err);
    assert!(contents(&kept) == before);
}
