//! Refusals of the program, by exit code; a refusal leaves no file behind and touches none.

use std::fs;
use std::path::Path;
use std::process::Output;

use insta::assert_snapshot;

use super::program::{SCENE, command, folder, names, run, shown, without_vulkan};

/// Runs with a scene and expects the code and an untouched folder; the command and its message.
fn refused(scene: &str, arguments: &[&str], code: i32) -> String {
    let folder = folder(scene);
    let run = run(folder.path(), arguments);
    assert_eq!(run.code, Some(code), "{arguments:?}: {}", run.err);
    assert_eq!(run.out, "", "{arguments:?}");
    assert_eq!(names(folder.path()), ["scene.scn"], "{arguments:?}");
    shown(arguments, &run.err)
}

#[test]
fn a_wrong_command_line_is_2() {
    let lines = [
        "",
        "scene.scn other.scn",
        "scene.scn --nonsense",
        "scene.scn -o a.jpg",
        "scene.scn -o a.png -o b",
        "scene.scn --spp 0",
        "scene.scn --spp 4294967296",
        "scene.scn --time 0",
        "scene.scn --time -2",
        "scene.scn --time NaN",
        "scene.scn --time inf",
        "scene.scn --target-error 0",
        "scene.scn --target-error -1e-3",
        "scene.scn --target-error nan",
        "scene.scn --target-error 5%",
        "scene.scn --seed -1",
        "scene.scn --size 400",
        "scene.scn --size 0x3",
        "scene.scn --crop 3,0,3,1",
        "scene.scn --crop 0,0,9,6",
        "scene.scn --crop 0,0,5,4 --size 4x4",
        "scene.scn --trace 8,0,0",
        "scene.scn --trace 1,1",
        "scene.scn --roulette 1.5",
        "scene.scn --exposure bright",
        "scene.scn --model mine",
        "scene.scn --fresnel none",
        "scene.scn --distribution blinn",
        "scene.scn --absorption no",
        "scene.scn --radiance-scaling yes",
        "scene.scn --lobe x",
        "scene.scn --normals x",
        "scene.scn --aov colour",
        "scene.scn --aov stderr --spp 1",
        "scene.scn --aov stderr -o a.png -o a-stderr.exr",
        "scene.scn --connect x",
        "scene.scn --sampler x",
        "devices scene.scn",
    ];
    let messages = lines.map(|line| {
        let arguments: Vec<&str> = line.split_whitespace().collect();
        refused(SCENE, &arguments, 2)
    });
    assert_snapshot!(messages.concat());
}

/// The flag says what it takes, also of a number that begins with a minus.
#[test]
fn a_wrong_number_is_refused_with_its_flag() {
    let lines = [
        "scene.scn --spp 1e3",
        "scene.scn --spp -1",
        "scene.scn --seed -1",
        "scene.scn --seed 1.5",
        "scene.scn --seed 4294967296",
        "scene.scn --max-depth -1",
        "scene.scn --exposure -inf",
        "scene.scn --exposure -nan",
        "scene.scn --crop -1,0,4,4",
        "scene.scn --size -1x3",
        "scene.scn --trace -1,0,0",
        "scene.scn --roulette -0.5",
        "scene.scn --roulette -on",
        "scene.scn --time -inf",
        "scene.scn --target-error -x",
        "compare a b --max-relmse -1e-3",
        "compare a b --exposure -inf",
        "compare --paired scene.scn --spp 1e3",
        "converge scene.scn --replicates -1",
        "converge scene.scn --seed -1",
        "converge scene.scn --exposure -nan",
        "explain scene.scn --crop -1,0,4,4",
        "export scene.scn --size -1x3",
    ];
    let messages = lines.map(|line| {
        let arguments: Vec<&str> = line.split(' ').collect();
        refused(SCENE, &arguments, 2)
    });
    assert_snapshot!(messages.concat());
}

#[test]
fn a_wrong_scene_is_3_and_shows_every_line() {
    let scene =
        "screen 8 6\ncamera 0 0 5 0.3\nsphere 0 0 0 -1\nbox 0 0 0 1 1 b\nmesh none.ply 0 0 0 1\n";
    let messages = [
        refused(scene, &["scene.scn"], 3),
        refused(SCENE, &["none.scn"], 3),
    ];
    assert_snapshot!(messages.concat());
}

#[test]
fn strict_makes_a_warning_3() {
    let warned = format!("{SCENE}torus 0 0 0 1 2\n");
    let strict = ["--strict", "scene.scn"];
    // Found by the preparation, not by the reader: two glass spheres that overlap.
    let overlap = "screen 8 6\ncamera 0 0 5 0.3\nbrdf 0 0 0 .1 .1 .1 .1 .9 .9 .9 1.5\n\
        sphere 0 0 0 1\nsphere 1 0 0 1\nlight 1 1 1\nsphere 0 9 0 1\n";
    let messages = [refused(&warned, &strict, 3), refused(overlap, &strict, 3)];
    assert_snapshot!(messages.concat());
}

#[test]
fn a_scene_with_errors_leaves_older_pictures_alone() {
    let folder = folder("nonsense");
    fs::write(folder.path().join("scene.png"), "old").expect("an old picture");
    assert_eq!(run(folder.path(), &["scene.scn"]).code, Some(3));
    assert_eq!(
        fs::read(folder.path().join("scene.png")).expect("the old picture"),
        b"old"
    );
    assert_eq!(names(folder.path()), ["scene.png", "scene.scn"]);
}

#[test]
fn no_such_device_is_4() {
    if without_vulkan() {
        return;
    }
    for device in ["99", "no such device"] {
        // It lists this machine's devices: no snapshot.
        let message = refused(SCENE, &["scene.scn", "--device", device], 4);
        let (_, printed) = message.split_once('\n').expect("a command and its message");
        assert!(printed.contains(device), "{message}");
    }
}

#[test]
fn no_vulkan_is_4_with_advice() {
    let folder = folder(SCENE);
    for arguments in [&["scene.scn", "--device", "0"][..], &["devices"][..]] {
        let output = blind(folder.path(), arguments);
        let printed = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(4), "{printed}");
        assert!(
            printed.contains("mesa-vulkan-drivers") && printed.contains("--device cpu-f64"),
            "{printed}"
        );
        assert_eq!(names(folder.path()), ["scene.scn"]);
    }
}

#[test]
fn without_vulkan_the_reference_renders_and_says_so() {
    let folder = folder(SCENE);
    let output = blind(folder.path(), &["scene.scn", "-o", "blind.exr"]);
    let printed = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{printed}");
    let last = "on cpu-f32, as no Vulkan device is usable";
    assert!(printed.trim_end().ends_with(last), "{printed}");
    let reference = ["scene.scn", "--device", "cpu-f32", "-o", "asked.exr"];
    let asked = run(folder.path(), &reference);
    assert!(!asked.out.contains("on cpu-f32,"), "{}", asked.out);
    let bytes = |name| fs::read(folder.path().join(name)).expect("a picture");
    assert!(bytes("blind.exr") == bytes("asked.exr"));
}

/// The program where the loader finds no driver.
fn blind(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = command(folder, arguments);
    command
        .env("VK_ICD_FILENAMES", "/none")
        .env("VK_DRIVER_FILES", "/none");
    command.output().expect("the program runs")
}

#[test]
fn a_file_that_cannot_be_written_is_5() {
    let messages = [
        refused(SCENE, &["scene.scn", "-o", "none/a.png"], 5),
        refused(SCENE, &["scene.scn", "--json", "none/a.json"], 5),
    ];
    assert_snapshot!(messages.concat());
    let folder = folder(SCENE);
    fs::create_dir(folder.path().join("a.png")).expect("a folder in the way");
    let run = run(folder.path(), &["scene.scn", "-o", "a.png"]);
    assert_eq!(run.code, Some(5), "{}", run.err);
    assert!(Path::new(&folder.path().join("a.png")).is_dir());
}

/// Found out before anything is rendered: the picture itself could be written.
#[test]
fn standard_errors_that_cannot_be_written_are_5() {
    let folder = folder(SCENE);
    fs::create_dir(folder.path().join("a-stderr.exr")).expect("a folder in the way");
    let run = run(
        folder.path(),
        &["scene.scn", "-o", "a.png", "--aov", "stderr"],
    );
    assert_eq!(run.code, Some(5), "{}", run.err);
    assert!(run.err.contains("cannot write a-stderr.exr"), "{}", run.err);
    assert_eq!(names(folder.path()), ["a-stderr.exr", "scene.scn"]);
}

/// A file that is no scene: the first errors are shown, the rest counted.
#[test]
fn the_first_of_many_errors_are_printed() {
    let lines: String = (0..3000).map(|i| format!("v {i} 0 0\n")).collect();
    let folder = folder(&lines);
    let run = run(folder.path(), &["scene.scn"]);
    assert_eq!(run.code, Some(3));
    let shown = run
        .err
        .lines()
        .filter(|l| l.contains("[scene.scn:"))
        .count();
    // Errors go first: both screen and camera are missing. 18 of the words that vkpt does not know are left.
    assert_eq!(shown, 18, "{}", run.err);
    assert!(run.err.contains("no `screen`"), "{}", run.err);
    assert!(run.err.contains("… and 2982 more\n"), "{}", run.err);
    assert!(run.err.contains("2 errors, 3000 warnings"), "{}", run.err);
}
