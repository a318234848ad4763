//! Two programs that would write one file.

use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use vkpt::image::claim::Claim;

use super::program::{MESH, MESHED, Run, SCENE, command, folder, names, without_vulkan, words};

const RENDER: &str = "scene.scn --device cpu-f32 --spp 2 --quiet";

/// A rendering that would take days, once it has claimed the one file that it writes.
fn endless(folder: &Path, picture: &str) -> Child {
    let line = format!("scene.scn --device cpu-f32 --spp 4294967295 --quiet -o {picture}");
    let mut child = command(folder, &line.split(' ').collect::<Vec<_>>())
        .stdin(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it runs");
    let start = Instant::now();
    while !folder.join(format!(".vkpt-{picture}.lock")).exists() {
        let ended = child.try_wait().expect("a child");
        assert!(ended.is_none() && start.elapsed() < Duration::from_secs(60));
        std::thread::sleep(Duration::from_millis(10));
    }
    child
}

fn is_refused(ran: &Run, name: &str) {
    let message = format!(
        "error: cannot write {name}: another vkpt is writing it; wait for it, or use another name\n"
    );
    assert_eq!((ran.code, ran.err.as_str()), (Some(5), message.as_str()));
    assert_eq!(ran.out, "");
}

/// And a killed one blocks no other.
#[test]
fn the_later_writer_of_a_picture_is_refused() {
    let folder = folder(SCENE);
    fs::write(folder.path().join("a.exr"), "old").expect("a file");
    fs::create_dir(folder.path().join("in")).expect("a folder");
    let mut first = endless(folder.path(), "a.exr");
    let render = |name: &str| words(folder.path(), &format!("{RENDER} -o {name}"));
    for name in ["a.exr", "in/../a.exr"] {
        is_refused(&render(name), name);
    }
    let both = render("b.exr -o a.exr");
    is_refused(&both, "a.exr");
    assert_eq!(render("b.exr").code, Some(0));
    let old = fs::read(folder.path().join("a.exr")).expect("a file");
    assert_eq!(old, b"old");

    first.kill().and_then(|()| first.wait()).expect("killed");
    let all = [
        ".vkpt-a.exr.lock",
        ".vkpt-a.vkpt.lock",
        "a.exr",
        "b.exr",
        "in",
        "scene.scn",
    ];
    assert_eq!(names(folder.path()), all);
    let ran = render("a.exr");
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_eq!(names(folder.path()), all[2..]);
    let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a picture");
    assert!(bytes("a.exr") == bytes("b.exr"));
}

/// Each with one of its outputs claimed.
#[test]
fn every_command_claims_its_outputs() {
    let folder = folder(MESHED);
    let path = folder.path();
    fs::write(path.join("m.ply"), MESH).expect("a mesh");
    words(path, &format!("{RENDER} -o p.png"));
    let scene = "scene.scn --device cpu-f32 --spp 4294967295";
    let mut rows = vec![
        (format!("{scene} -o a.png --json a.json"), "a.json"),
        (format!("{scene} -o a.png --aov stderr"), "a-stderr.exr"),
        (scene.to_owned(), "scene.exr"),
        (format!("converge {scene} --csv a.csv"), "a.csv"),
        ("compare p.png p.png --heatmap a.png".to_owned(), "a.png"),
        ("explain scene.scn --spirv a.spv".to_owned(), "a.spv"),
        (
            "explain scene.scn --integrator bidirectional --spirv a.spv".to_owned(),
            "a-2.spv",
        ),
        ("export scene.scn --to mitsuba".to_owned(), "scene-4.ply"),
        ("check --html a.html".to_owned(), "a.html"),
    ];
    if !without_vulkan() {
        rows.push(("doctor --json a.json".to_owned(), "a.json"));
    }
    for (line, name) in rows {
        let claim = Claim::new(&path.join(name)).expect("free");
        is_refused(&words(path, &line), name);
        drop(claim);
        assert_eq!(names(path), ["m.ply", "p.png", "scene.scn"], "{line}");
    }
}
