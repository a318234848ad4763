//! `scripts/gpu`: the folder that it leaves, also if parts fail, and its messages if it cannot begin.

use std::fs;
use std::path::Path;
use std::process::Command;

use vkpt::gpu::Device;

use super::program::program;
use crate::cli::program::{Run, SCENE, finish, folder, names, without_vulkan};
use crate::common;

const VKPT: &str = env!("CARGO_BIN_EXE_vkpt");
const PARTS: [&str; 7] = [
    "devices", "doctor", "kernels", "render", "paired", "check", "speed",
];

/// The script, with another program instead of vkpt.
fn gpu(vkpt: &Path, arguments: &[&str]) -> Run {
    finish(
        Command::new("scripts/gpu")
            .current_dir(common::root())
            .args(arguments)
            .env("VKPT", vkpt),
    )
}

fn readme(out: &Path) -> String {
    fs::read_to_string(out.join("README.md")).expect("a summary")
}

/// The fields of a part in the summary other than its name and its seconds.
fn outcome<'a>(readme: &'a str, part: &str) -> &'a str {
    let begin = format!("| [{part}]({part}.txt) | ");
    let row = readme.lines().find_map(|line| line.strip_prefix(&begin));
    let row = row.unwrap_or_else(|| panic!("{part} is missing:\n{readme}"));
    row.split(" | ").next().unwrap_or_default()
}

/// By vkpt itself; of the battery one case.
#[test]
fn all_of_it_lies_in_one_folder() {
    if without_vulkan() {
        return;
    }
    let folder = folder(SCENE);
    let one_case = format!(
        "[ \"$1\" != check ] || set -- \"$@\" --case camera/one-pixel\nexec '{VKPT}' \"$@\""
    );
    let vkpt = program(folder.path(), "one-case", &one_case);
    let scene = folder.path().join("lit.txt");
    fs::write(&scene, SCENE).expect("a scene");
    let out = folder.path().join("new/out");
    let device = Device::open(&common::selector()).expect("a device");
    let index = device.info().index.to_string();
    let ran = gpu(
        &vkpt,
        &[&index, &out.to_string_lossy(), &scene.to_string_lossy()],
    );
    let readme = readme(&out);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (Some(0), ""),
        "{}\n{readme}",
        ran.err
    );
    assert!(readme.contains(&device.info().name), "{readme}");
    for part in PARTS {
        assert_eq!(outcome(&readme, part), "passed", "{readme}");
    }
    let speed = readme
        .lines()
        .find(|line| line.starts_with(&format!("| {} ", scene.display())));
    let figures: Vec<f64> = speed
        .expect("the speed of the scene")
        .split('|')
        .filter_map(|cell| cell.trim().parse().ok())
        .collect();
    assert!(
        figures.len() == 2 && figures.iter().all(|ns| *ns > 0.0),
        "{readme}"
    );
    assert!(readme.contains("](lit.png)"), "{readme}");
    let expected = [
        "README.md",
        "check.html",
        "check.json",
        "check.txt",
        "devices.txt",
        "doctor.json",
        "doctor.txt",
        "kernels.txt",
        "lit.png",
        "paired.txt",
        "render.txt",
        "speed.txt",
    ];
    assert_eq!(names(&out), expected);
}

/// By a program that renders `b.txt` and examines devices without success.
#[test]
fn failures_are_named_and_lose_nothing_else() {
    let folder = folder("");
    let fake = r#"
case "$*" in
    explain*) echo "$2: 8×6 pixels; limits: Fake" ;;
    doctor*) echo "not healthy"; exit 1 ;;
    *b.txt*--spp*) echo "device lost" >&2; exit 3 ;;
    *--kernel*) printf '  "scene": "%s",\n  "choice": "%s",\n    "gpu": 3.0,\n  "samples": 200,\n' "$1" "$9" ;;
esac"#;
    let vkpt = program(folder.path(), "fake", fake);
    let out = folder.path().join("out");
    let ran = gpu(&vkpt, &["0", &out.to_string_lossy(), "a.txt", "b.txt"]);
    let readme = readme(&out);
    assert_eq!(ran.code, Some(1), "{}\n{readme}", ran.err);
    for part in PARTS {
        let expected = match part {
            "doctor" => "FAILED, exit code 1",
            "render" | "paired" => "FAILED, exit code 3: b.txt",
            _ => "passed",
        };
        assert_eq!(outcome(&readme, part), expected, "{readme}");
        assert!(
            ran.err.contains(&format!("{part}: {expected}\n")),
            "{}",
            ran.err
        );
    }
    let text = fs::read_to_string(out.join("render.txt")).expect("what it printed");
    assert!(text.contains("device lost"), "{text}");
    assert!(
        readme.contains("| a.txt | 15000000 | 15000000 |"),
        "{readme}"
    );
}

#[test]
fn where_it_cannot_begin_there_is_one_message_and_no_folder() {
    let folder = folder(SCENE);
    let out = folder.path().join("out");
    let out_name = out.to_string_lossy();
    let rows: &[(&str, &[&str], i32, &str)] = &[
        (VKPT, &[], 2, "usage: scripts/gpu DEVICE"),
        ("none/vkpt", &["0", &out_name], 1, "cargo build --release"),
        (VKPT, &["nosuch", &out_name], 4, "error: no "),
        (VKPT, &["cpu-f32", &out_name], 2, "a Vulkan device"),
    ];
    for (vkpt, arguments, code, message) in rows {
        let ran = gpu(Path::new(vkpt), arguments);
        assert_eq!(
            (ran.code, ran.out.as_str()),
            (Some(*code), ""),
            "{}",
            ran.err
        );
        assert!(ran.err.contains(message), "{arguments:?}: {}", ran.err);
        let paragraph = ran.err.split("\n\n").next().unwrap_or_default();
        assert_eq!(paragraph.trim_end().lines().count(), 1, "{}", ran.err);
        assert!(!out.exists(), "{arguments:?}");
    }
}
