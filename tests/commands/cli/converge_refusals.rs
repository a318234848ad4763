//! Refusals of `vkpt converge`: one clear message each, no file written, none touched.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use vkpt::film::Film;
use vkpt::image::file::write_whole;
use vkpt::image::{Format, Frame, Labels, encode};

use super::converge::{LIT, reference};
use super::program::{folder, names, run, shown};

/// Runs with `--json` and the flags of `line`, and expects the code, one message and an untouched folder; the command and
/// its message.
fn refused(folder: &Path, code: i32, line: &str) -> String {
    let before = names(folder);
    let mut arguments = vec!["converge", "scene.scn", "--device", "cpu-f32"];
    arguments.extend(line.split(' '));
    arguments.extend(["--json", "c.json"]);
    let refused = run(folder, &arguments);
    assert_eq!(refused.code, Some(code), "{line}: {}", refused.err);
    let messages = refused.err.matches("error: ").count();
    assert_eq!(messages, 1, "{line}: {}", refused.err);
    assert!(!refused.err.contains("warning"), "{line}: {}", refused.err);
    assert_eq!(refused.out, "", "{line}");
    assert_eq!(names(folder), before, "{line}");
    shown(&arguments, &refused.err)
}

/// A grey EXR of the scene's size with one odd value, in the last row but one.
fn write_picture(path: &Path, odd: f32) {
    let mut film = Film {
        width: 12,
        height: 8,
        rgb: vec![[0.5; 3]; 96],
    };
    film.rgb[6 * 12 + 5][1] = odd;
    let frame = Frame::whole(&film);
    let labels = Labels {
        exposure: 0.0,
        software: "test",
        notes: &[],
    };
    write_whole(path, |out| encode(&frame, Format::Exr, &labels, out)).expect("a picture");
}

#[test]
fn settings_that_cannot_be_measured_are_a_wrong_command_line() {
    let folder = folder(LIT);
    let lines = [
        "--replicates 1",
        "--replicates 0",
        "--replicates -8",
        "--spp 0",
        "--spp 4294967296",
        "--time 0",
        "--time -1",
        "--time NaN",
        "--time inf",
        "--vary colour=red",
        "--vary connect=all",
        "--vary connect=mis --vary connect=light",
        "--html ./c.json",
        "--crop 0,0,13,8",
    ];
    let messages = lines.map(|line| refused(folder.path(), 2, line));
    assert_snapshot!(messages.concat());
}

/// The halves of the reference have the last two seeds.
#[test]
fn replicates_have_no_seed_of_the_reference() {
    let folder = folder(LIT);
    let seeds = ["4294967287", "4294967294", "4294967295", "4294967296"];
    let messages = seeds.map(|seed| refused(folder.path(), 2, &format!("--seed {seed}")));
    assert_snapshot!(messages.concat());
    let last = [
        "--seed",
        "4294967286",
        "--spp",
        "1",
        "--time",
        "0.1",
        "--quiet",
    ];
    let arguments = [&["converge", "scene.scn", "--device", "cpu-f32"], &last[..]].concat();
    assert_eq!(run(folder.path(), &arguments).code, Some(0));
}

#[test]
fn a_reference_must_be_a_picture_of_that_size() {
    let folder = folder(LIT);
    let folder = folder.path();
    reference(folder, "r.exr");
    fs::write(folder.join("no.exr"), "no picture").expect("a file");
    fs::create_dir(folder.join("folder.exr")).expect("a folder");
    for (name, odd) in [
        ("nan.exr", f32::NAN),
        ("inf.exr", f32::INFINITY),
        ("good.exr", 0.5),
    ] {
        write_picture(&folder.join(name), odd);
    }
    write_picture(&folder.join("good-stderr.exr"), -0.1);
    // A folder that is read as a file: the system's own words, and no snapshot.
    refused(folder, 3, "--reference folder.exr");
    let lines = [
        "--reference none.exr",
        "--reference no.exr",
        "--reference nan.exr",
        "--reference inf.exr",
        "--reference good.exr",
        "--reference r.exr --size 6x4",
        "--reference r.exr --crop 0,0,6,4",
    ];
    let messages = lines.map(|line| refused(folder, 3, line));
    assert_snapshot!(messages.concat());
}

#[test]
fn files_that_cannot_be_written_are_found_out_first() {
    let folder = folder(LIT);
    let lines = ["--csv none/c.csv", "--svg none/c.svg", "--html none/c.html"];
    let messages = lines.map(|line| refused(folder.path(), 5, line));
    assert_snapshot!(messages.concat());
}
