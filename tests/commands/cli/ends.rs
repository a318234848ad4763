//! `--time` and `--target-error`, and the error that a rendering reports.

use std::fs;
use std::path::Path;

use serde_json::Value;

use super::program::{Run, folder, run};

const SCENE: &str = "screen 32 24\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

/// Renders by the reference to `NAME.exr` and `NAME.json`.
fn render(folder: &Path, name: &str, flags: &[&str]) -> (Run, Value) {
    let (picture, json) = (format!("{name}.exr"), format!("{name}.json"));
    let common = [
        "scene.scn",
        "--device",
        "cpu-f32",
        "-o",
        &picture,
        "--json",
        &json,
    ];
    let run = run(folder, &[&common, flags].concat());
    assert_eq!(run.code, Some(0), "{}", run.err);
    let text = fs::read_to_string(folder.join(json)).expect("a report");
    (run, serde_json::from_str(&text).expect("JSON"))
}

/// The file is that of `--spp` as many as were reached, header and all.
#[test]
fn time_and_error_leave_the_picture_of_the_spp_they_reached() {
    let folder = folder(SCENE);
    for (flag, value, ended) in [
        ("--time", "0.1", "time"),
        ("--target-error", "0.2", "target-error"),
    ] {
        let (run, json) = render(folder.path(), "a", &[flag, value]);
        assert_eq!((&json["ended"], run.err.as_str()), (&ended.into(), ""));
        let spp = json["spp"].as_u64().expect("a number").to_string();
        render(folder.path(), "b", &["--spp", &spp]);
        let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a picture");
        assert!(
            bytes("a.exr") == bytes("b.exr"),
            "{flag}: not the picture of --spp {spp}"
        );
    }
}

#[test]
fn the_samples_asked_for_are_the_most_there_are() {
    let folder = folder(SCENE);
    let flags = ["--spp", "3", "--time", "1000", "--target-error", "1e-9"];
    let (run, json) = render(folder.path(), "a", &flags);
    assert_eq!(
        (&json["ended"], &json["spp"]),
        (&"complete".into(), &3.into())
    );
    assert!(
        run.err
            .contains("not below --target-error 1e-9: --spp ended"),
        "{}",
        run.err
    );
}

#[test]
fn the_report_has_the_curve_and_the_last_line_its_end() {
    let folder = folder(SCENE);
    let (run, json) = render(folder.path(), "a", &["--spp", "48"]);
    let errors = json["error"].as_array().expect("a list");
    let spp: Vec<u64> = errors.iter().filter_map(|e| e["spp"].as_u64()).collect();
    assert_eq!(spp, [1, 2, 4, 8, 16, 32, 48]);
    assert!(errors[0]["rel_mse"].is_null());
    let of = |i: usize, name: &str| errors[i][name].as_f64().expect("a number");
    assert!(of(6, "low") < of(6, "rel_mse") && of(6, "rel_mse") < of(6, "high"));
    assert!(of(6, "seconds") >= of(5, "seconds"));
    let line = run.out.lines().last().expect("a line");
    assert!(
        line.starts_with("48 spp · ") && line.contains("relMSE ") && line.contains("95 %"),
        "{line}"
    );
}
