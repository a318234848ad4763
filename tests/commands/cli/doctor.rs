//! `vkpt doctor`: what it prints and writes, and how it ends.

use std::fs;

use super::program::{command, finish, folder, names, run, without_vulkan};

#[test]
fn the_page_begins_with_the_verdict_and_the_record_holds_every_finding() {
    if without_vulkan() {
        return;
    }
    let folder = folder("");
    let run = run(folder.path(), &["doctor", "--json", "doctor.json"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{}", run.out);
    let first = run.out.lines().next().unwrap_or_default();
    assert!(first.contains(": healthy"), "{first}");
    for words in [
        "Self-tests",
        "loop with one exit",
        "x ÷ y",
        "sincos_2pi",
        "Vulkan allows",
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
    ] {
        assert!(json[list].as_array().is_some_and(|l| l.len() > 3), "{list}");
    }
    assert_eq!(json["operations"][0]["outcome"], "passes");
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
