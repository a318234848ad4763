//! Refusals of `vkpt converge`: one clear message each, no file written, none touched.

use std::fs;
use std::path::Path;

use vkpt::film::Film;
use vkpt::image::file::write_whole;
use vkpt::image::{Format, Frame, Labels, encode};

use super::converge::{LIT, reference};
use super::program::{folder, names, run};

/// Runs with `--json` and `more`, and expects code and message.
fn refused(folder: &Path, more: &[&str], code: i32, said: &str) {
    let before = names(folder);
    let mut arguments = vec!["converge", "scene.scn", "--device", "cpu-f32"];
    arguments.extend(more);
    arguments.extend(["--json", "c.json"]);
    let refused = run(folder, &arguments);
    assert_eq!(refused.code, Some(code), "{more:?}: {}", refused.err);
    assert!(refused.err.contains(said), "{more:?}: {}", refused.err);
    let messages = refused.err.matches("error: ").count();
    assert_eq!(messages, 1, "{more:?}: {}", refused.err);
    assert!(
        !refused.err.contains("warning"),
        "{more:?}: {}",
        refused.err
    );
    assert_eq!(refused.out, "", "{more:?}");
    assert_eq!(names(folder), before, "{more:?}");
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
fn what_cannot_be_measured_is_a_wrong_command_line() {
    let folder = folder(LIT);
    let rows: &[(&[&str], &str)] = &[
        (
            &["--replicates", "1"],
            "one replicate gives no interval: 2 or more are needed",
        ),
        (&["--replicates", "0"], "from 2 to 1000"),
        (&["--replicates", "-8"], "from 2 to 1000"),
        (&["--spp", "0"], "a whole number from 1 to 4294967295"),
        (
            &["--spp", "4294967296"],
            "a whole number from 1 to 4294967295",
        ),
        (&["--time", "0"], "seconds above 0"),
        (&["--time", "-1"], "seconds above 0"),
        (&["--time", "NaN"], "seconds above 0"),
        (&["--time", "inf"], "seconds above 0"),
        (&["--vary", "colour=red"], "no such setting"),
        (&["--vary", "connect=all"], "invalid value 'all'"),
        (
            &["--vary", "connect=mis", "--vary", "connect=light"],
            "given twice",
        ),
        (
            &["--html", "./c.json"],
            "two outputs would be written to the same file",
        ),
        (&["--crop", "0,0,13,8"], "outside the picture of 12x8"),
    ];
    for (more, said) in rows {
        refused(folder.path(), more, 2, said);
    }
}

/// The halves of the reference have the last two seeds.
#[test]
fn replicates_have_no_seed_of_the_reference() {
    let folder = folder(LIT);
    let said = "its replicates would use the seeds of the reference";
    for seed in ["4294967287", "4294967294", "4294967295"] {
        refused(folder.path(), &["--seed", seed], 2, said);
    }
    refused(
        folder.path(),
        &["--seed", "4294967296"],
        2,
        "a whole number from 0 to 4294967295",
    );
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
    let of = |name: &'static str| ["--reference", name];
    let place = "in pixel 5,6 from the top left, channel G";
    let rows = [
        ("none.exr", "none.exr"),
        ("no.exr", "no.exr"),
        ("folder.exr", "folder.exr"),
        ("nan.exr", &format!("NaN {place}")),
        ("inf.exr", &format!("inf {place}")),
        ("good.exr", "errors at column 5, row 6, channel G"),
    ];
    for (name, said) in rows {
        refused(folder, &of(name), 3, said);
    }
    let small = ["--reference", "r.exr", "--size", "6x4"];
    refused(folder, &small, 3, "has 12×8 pixels, the renderings 6×4");
    let part = ["--reference", "r.exr", "--crop", "0,0,6,4"];
    refused(folder, &part, 3, "has 12×8 pixels, the renderings 6×4");
}

#[test]
fn files_that_cannot_be_written_are_found_out_first() {
    let folder = folder(LIT);
    refused(folder.path(), &["--csv", "none/c.csv"], 5, "none/c.csv");
    refused(folder.path(), &["--svg", "none/c.svg"], 5, "none/c.svg");
    refused(folder.path(), &["--html", "none/c.html"], 5, "none/c.html");
}
