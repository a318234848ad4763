//! `vkpt doctor`: its output, its files and its exit codes.

use std::fs;
#[cfg(unix)]
use std::{process::Stdio, time::Duration};

use vkpt_lab::check::select::SHORT;

#[cfg(unix)]
use super::interrupt::send;
use super::program::{command, finish, folder, names, run, without_vulkan};

#[test]
fn the_page_begins_with_the_verdict_and_the_record_has_every_finding() {
    if without_vulkan() {
        return;
    }
    let folder = folder("");
    let run = run(folder.path(), &["doctor", "--all", "--json", "doctor.json"]);
    assert_eq!(run.code, Some(0), "{}{}", run.out, run.err);
    // Nothing but progress, now and then.
    assert!(run.err.lines().all(|l| l.contains(" %, ")), "{}", run.err);
    let first = run.out.lines().next().unwrap_or_default();
    assert!(first.contains(": healthy"), "{first}");
    for words in [
        "Self-tests",
        "loop with one exit",
        "x ÷ y",
        "sincos_2pi",
        "Battery",
        "light/in-glass",
        "Vulkan allows",
        "Nanoseconds",
        "dispatches to take",
        "subgroup",
    ] {
        assert!(run.out.contains(words), "{words} is missing:\n{}", run.out);
    }
    assert_eq!(names(folder.path()), ["doctor.json", "scene.scn"]);
    let text = fs::read_to_string(folder.path().join("doctor.json")).expect("a record");
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["verdict"]["healthy"], true);
    for list in [
        "self_tests",
        "operations",
        "own_functions",
        "driver_functions",
        "costs",
        "habits",
    ] {
        assert!(json[list].as_array().is_some_and(|l| l.len() > 2), "{list}");
    }
    assert_eq!(json["operations"][0]["outcome"], "passes");
    let cases = json["battery"]["cases"].as_array().expect("cases");
    assert_eq!(cases.len(), SHORT.len());
    for (case, name) in cases.iter().zip(SHORT) {
        assert_eq!(case["name"], name);
        assert!(case["margin"].as_f64().is_some_and(|m| m <= 1.0), "{case}");
    }
}

#[test]
fn parts_that_decide_nothing_are_examined_on_request_alone() {
    if without_vulkan() {
        return;
    }
    let folder = folder("");
    let run = run(folder.path(), &["doctor", "--quiet", "--json", "-"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{}", run.out);
    let json: serde_json::Value = serde_json::from_str(&run.out).expect("JSON");
    for list in ["habits", "driver_functions", "costs"] {
        assert!(json[list].is_null(), "{list}");
    }
    assert_eq!(json["battery"]["passed"], true);
}

/// Met in the middle of an examination of minutes, it prints what it found.
#[cfg(unix)]
#[test]
fn ctrl_c_leaves_the_findings_without_a_verdict() {
    if without_vulkan() {
        return;
    }
    let folder = folder("");
    for delay in [1, 2, 4, 8, 16] {
        let mut command = command(folder.path(), &["doctor", "--exhaustive"]);
        let child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it runs");
        std::thread::sleep(Duration::from_secs(delay));
        send(child.id(), "INT");
        let output = child.wait_with_output().expect("it ends");
        // One that did not listen yet ended at once.
        if output.status.code().is_none() {
            continue;
        }
        let [out, err] =
            [output.stdout, output.stderr].map(|o| String::from_utf8(o).expect("text"));
        assert_eq!(output.status.code(), Some(130), "{out}{err}");
        assert!(err.contains("warning: interrupted"), "{err}");
        let first = out.lines().next().unwrap_or_default();
        assert!(first.contains(": interrupted: "), "{out}");
        assert!(out.contains("loop with one exit"), "{out}");
        return;
    }
    panic!("it never listened");
}

#[test]
fn without_a_device_or_a_place_to_write_there_is_an_exit_code() {
    let folder = folder("");
    let mut without = command(folder.path(), &["doctor"]);
    let nowhere = "/nowhere.json";
    without
        .env("VK_DRIVER_FILES", nowhere)
        .env("VK_ICD_FILENAMES", nowhere);
    let ended = finish(&mut without);
    assert_eq!((ended.code, ended.out.as_str()), (Some(4), ""));
    assert!(ended.err.contains("no Vulkan device"), "{}", ended.err);
    let code = |arguments: &[&str]| run(folder.path(), arguments).code;
    assert_eq!(code(&["doctor", "--json", "none/doctor.json"]), Some(5));
    assert_eq!(code(&["doctor", "--device", "cpu-f64"]), Some(2));
    assert_eq!(code(&["doctor", "scene.scn"]), Some(2));
}
