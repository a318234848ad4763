//! Refusals of the program, by exit code; a refusal leaves no file behind and touches none.

use std::fs;
use std::path::Path;
use std::process::Output;

use super::program::{SCENE, command, folder, names, run, without_vulkan};

/// Runs with a scene and expects the code, a message that contains `said`, and an untouched folder.
fn refused(scene: &str, arguments: &[&str], code: i32, said: &str) {
    let folder = folder(scene);
    let run = run(folder.path(), arguments);
    assert_eq!(run.code, Some(code), "{arguments:?}: {}", run.err);
    assert!(run.err.contains(said), "{arguments:?}: {}", run.err);
    assert_eq!(run.out, "", "{arguments:?}");
    assert_eq!(names(folder.path()), ["scene.scn"], "{arguments:?}");
}

#[test]
fn a_wrong_command_line_is_2() {
    let rows: &[(&[&str], &str)] = &[
        (&[], "<SCENE>"),
        (&["scene.scn", "other.scn"], "other.scn"),
        (&["scene.scn", "--nonsense"], "--nonsense"),
        (&["scene.scn", "-o", "a.jpg"], ".png, .hdr, .exr or .vkpt"),
        (
            &["scene.scn", "-o", "a.png", "-o", "b"],
            ".png, .hdr, .exr or .vkpt",
        ),
        (&["scene.scn", "--spp", "0"], "--spp"),
        (&["scene.scn", "--spp", "4294967296"], "--spp"),
        (&["scene.scn", "--time", "0"], "--time"),
        (&["scene.scn", "--time", "-2"], "--time"),
        (&["scene.scn", "--time", "NaN"], "seconds above 0"),
        (&["scene.scn", "--time", "inf"], "seconds above 0"),
        (&["scene.scn", "--target-error", "0"], "--target-error"),
        (&["scene.scn", "--target-error", "-1e-3"], "--target-error"),
        (&["scene.scn", "--target-error", "nan"], "above 0"),
        (&["scene.scn", "--target-error", "5%"], "such as 1e-3"),
        (&["scene.scn", "--seed", "-1"], "-1"),
        (&["scene.scn", "--size", "400"], "400x300"),
        (&["scene.scn", "--size", "0x3"], "1 to 16384"),
        (&["scene.scn", "--crop", "3,0,3,1"], "no pixels"),
        (
            &["scene.scn", "--crop", "0,0,9,6"],
            "outside the picture of 8x6",
        ),
        (
            &["scene.scn", "--crop", "0,0,5,4", "--size", "4x4"],
            "outside the picture of 4x4",
        ),
        (
            &["scene.scn", "--trace", "8,0,0"],
            "outside the picture of 8x6",
        ),
        (&["scene.scn", "--trace", "1,1"], "three whole numbers"),
        (&["scene.scn", "--roulette", "1.5"], "at most 1"),
        (&["scene.scn", "--exposure", "bright"], "stops"),
        (&["scene.scn", "--model", "mine"], "handout"),
        (&["scene.scn", "--fresnel", "none"], "schlick, exact"),
        (
            &["scene.scn", "--distribution", "blinn"],
            "auto, phong, beckmann, ggx",
        ),
        (&["scene.scn", "--absorption", "no"], "segment, term"),
        (&["scene.scn", "--radiance-scaling", "yes"], "on, off"),
        (&["scene.scn", "--lobe", "x"], "fresnel, norms"),
        (&["scene.scn", "--normals", "x"], "visible, distribution"),
        (&["scene.scn", "--aov", "colour"], "stderr"),
        (
            &["scene.scn", "--aov", "stderr", "--spp", "1"],
            "--spp 2 or more",
        ),
        (
            &[
                "scene.scn",
                "--aov",
                "stderr",
                "-o",
                "a.png",
                "-o",
                "a-stderr.exr",
            ],
            "overwrite the picture a-stderr.exr",
        ),
        (&["scene.scn", "--connect", "x"], "mis, light, bsdf"),
        (
            &["scene.scn", "--sampler", "x"],
            "random, sobol, sobol-quarters",
        ),
        (&["devices", "scene.scn"], "scene.scn"),
    ];
    for (arguments, said) in rows {
        refused(SCENE, arguments, 2, said);
    }
}

/// The flag says which values it takes, for any wrong number.
#[test]
fn a_wrong_number_is_told_by_its_flag() {
    let samples = "must be a whole number from 1 to 4294967295";
    let number = "must be a whole number from 0 to 4294967295";
    let stops = "must be a finite number of stops";
    let rows: [(&[&str], &str, &str, &str); 23] = [
        (&[], "--spp", "1e3", samples),
        (&[], "--spp", "-1", samples),
        (&[], "--seed", "-1", number),
        (&[], "--seed", "1.5", number),
        (&[], "--seed", "4294967296", number),
        (&[], "--max-depth", "-1", number),
        (&[], "--exposure", "-inf", stops),
        (&[], "--exposure", "-nan", stops),
        (
            &[],
            "--crop",
            "-1,0,4,4",
            "must be four whole numbers from 0",
        ),
        (&[], "--size", "-1x3", "must be two whole numbers from 1"),
        (
            &[],
            "--trace",
            "-1,0,0",
            "must be three whole numbers from 0",
        ),
        (&[], "--roulette", "-0.5", "must be above 0 and at most 1"),
        (
            &[],
            "--roulette",
            "-on",
            "must be throughput, off, or a probability",
        ),
        (
            &[],
            "--time",
            "-inf",
            "must be a finite number of seconds above 0",
        ),
        (
            &[],
            "--target-error",
            "-x",
            "must be a finite number above 0",
        ),
        (&["compare", "a", "b"], "--max-relmse", "-1e-3", "from 0 up"),
        (&["compare", "a", "b"], "--exposure", "-inf", stops),
        (&["compare", "--paired"], "--spp", "1e3", samples),
        (&["converge"], "--replicates", "-1", "from 2 to 1000"),
        (&["converge"], "--seed", "-1", number),
        (&["converge"], "--exposure", "-nan", stops),
        (
            &["explain"],
            "--crop",
            "-1,0,4,4",
            "must be four whole numbers",
        ),
        (&["export"], "--size", "-1x3", "must be two whole numbers"),
    ];
    for (command, flag, value, said) in rows {
        let scene: &[&str] = match command {
            ["compare", "a", "b"] => &[],
            _ => &["scene.scn"],
        };
        let arguments = [command, scene, &[flag, value]].concat();
        refused(SCENE, &arguments, 2, said);
        refused(
            SCENE,
            &arguments,
            2,
            &format!("invalid value '{value}' for '{flag}"),
        );
    }
}

#[test]
fn a_wrong_scene_is_3_and_shows_every_line() {
    let scene =
        "screen 8 6\ncamera 0 0 5 0.3\nsphere 0 0 0 -1\nbox 0 0 0 1 1 b\nmesh none.ply 0 0 0 1\n";
    for said in [
        "scene.scn:3:14",
        "scene.scn:4:15",
        "scene.scn:5:6",
        "scene.scn: 3 errors",
    ] {
        refused(scene, &["scene.scn"], 3, said);
    }
    refused(SCENE, &["none.scn"], 3, "none.scn");
}

#[test]
fn strict_makes_a_warning_3() {
    let warned = format!("{SCENE}torus 0 0 0 1 2\n");
    refused(&warned, &["--strict", "scene.scn"], 3, "torus");
    // Reported by the preparation, not by the reader: two glass spheres that overlap.
    let overlap = "screen 8 6\ncamera 0 0 5 0.3\nbrdf 0 0 0 .1 .1 .1 .1 .9 .9 .9 1.5\n\
        sphere 0 0 0 1\nsphere 1 0 0 1\nlight 1 1 1\nsphere 0 9 0 1\n";
    refused(overlap, &["--strict", "scene.scn"], 3, "--strict");
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
        refused(SCENE, &["scene.scn", "--device", device], 4, device);
    }
}

#[test]
fn no_vulkan_is_4_and_says_what_to_do() {
    let folder = folder(SCENE);
    for arguments in [&["scene.scn", "--device", "0"][..], &["devices"][..]] {
        let output = blind(folder.path(), arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(4), "{said}");
        assert!(
            said.contains("mesa-vulkan-drivers") && said.contains("--device cpu-f64"),
            "{said}"
        );
        assert_eq!(names(folder.path()), ["scene.scn"]);
    }
}

#[test]
fn without_vulkan_the_reference_renders_and_says_so() {
    let folder = folder(SCENE);
    let output = blind(folder.path(), &["scene.scn", "-o", "blind.exr"]);
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let last = "on cpu-f32, as no Vulkan device is usable";
    assert!(said.trim_end().ends_with(last), "{said}");
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
fn what_cannot_be_written_is_5() {
    for arguments in [
        &["scene.scn", "-o", "none/a.png"][..],
        &["scene.scn", "--json", "none/a.json"],
    ] {
        refused(SCENE, arguments, 5, "cannot write none/a.");
    }
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
fn of_many_errors_the_first_are_told() {
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
