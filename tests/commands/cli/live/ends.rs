//! How a rendering with a live view ends: with the same bits, without waiting if nobody is there, or when requested.

use std::fs;
use std::time::{Duration, Instant};

use serde_json::Value;

use super::{ENDLESS, PATIENCE, Rendering, SCENE, Tab, pixels, stop};
use crate::cli::program::{folder, names, words};

#[test]
fn looking_on_changes_no_bit() {
    let flags = "--spp 20000 --checkpoint off -o a.exr --json a.json";
    let plain = folder(SCENE);
    let run = words(plain.path(), &format!("scene.scn --device cpu-f32 {flags}"));
    assert_eq!(run.code, Some(0), "{}", run.err);
    let mut rendering = Rendering::start(flags);
    let port = rendering.port;
    // Two tabs that fetch every picture that is announced.
    let tab = |number: u32| {
        let mut tab = Tab::new(port, number);
        while tab.ask().is_some() {}
        tab.has
    };
    let pictures = std::thread::scope(|scope| {
        let tabs = [1, 2].map(|number| scope.spawn(move || tab(number)));
        tabs.map(|tab| tab.join().expect("a tab"))
    });
    assert!(pictures.iter().all(|&n| n >= 2), "{pictures:?}");
    let (code, stderr) = rendering.end();
    assert_eq!(code, Some(0), "{stderr}");
    let bytes = |folder: &std::path::Path| fs::read(folder.join("a.exr")).expect("a picture");
    assert!(
        bytes(plain.path()) == bytes(rendering.folder.path()),
        "other bits"
    );
    let json = |folder: &std::path::Path| -> Value {
        let text = fs::read_to_string(folder.join("a.json")).expect("a report");
        serde_json::from_str(&text).expect("JSON")
    };
    let rays = |folder| json(folder)["rays"].clone();
    assert_eq!(rays(plain.path()), rays(rendering.folder.path()));
}

#[test]
fn a_tab_gets_the_last_picture_before_the_end() {
    let mut rendering = Rendering::start("--spp 20000 --checkpoint off -o a.exr");
    let mut tab = Tab::new(rendering.port, 7);
    let state = tab.state(|state| state["phase"] == "ended");
    let last = &state["picture"];
    assert_eq!(
        (&state["samples"], &last["samples"]),
        (&20000.into(), &20000.into())
    );
    assert_eq!(
        (&state["spp"], &last["number"]),
        (&20000.into(), &tab.has.into())
    );
    // The tab is reported to have all, so the rendering waits no longer.
    let start = Instant::now();
    tab.ask();
    let (code, stderr) = rendering.end();
    assert_eq!(code, Some(0), "{stderr}");
    assert!(start.elapsed() < Duration::from_secs(1));
    assert!(
        pixels(tab.picture.as_ref().expect("a picture")) == rendering.picture("a.exr").rgb,
        "other pixels"
    );
}

#[test]
fn errors_are_those_of_the_report() {
    let mut rendering = Rendering::start("--spp 20000 --checkpoint off -o a.exr --json a.json");
    let state = Tab::new(rendering.port, 7).state(|state| state["phase"] == "ended");
    rendering.end();
    let text = fs::read_to_string(rendering.folder.path().join("a.json")).expect("a report");
    let report: Value = serde_json::from_str(&text).expect("JSON");
    let known = |all: &Value| {
        let all = all.as_array().expect("errors").iter();
        let all: Vec<_> = all.map(|e| e["spp"].as_u64()).collect();
        all
    };
    let last = state["errors"]
        .as_array()
        .and_then(|all| all.last())
        .expect("an error");
    let reported = report["error"]
        .as_array()
        .expect("errors")
        .last()
        .expect("one");
    assert_eq!(last["spp"], reported["spp"]);
    assert_eq!(last["seconds"], reported["seconds"]);
    // The first sample gives no estimate of its error.
    assert_eq!(known(&state["errors"])[..], known(&report["error"])[1..]);
}

#[test]
fn where_nobody_looks_on_it_waits_for_nobody() {
    let took = |flags: &str| {
        let folder = folder(SCENE);
        let start = Instant::now();
        let line = format!("scene.scn --device cpu-f32 --spp 4 -o a.exr {flags}");
        let run = words(folder.path(), line.trim_end());
        assert_eq!(run.code, Some(0), "{}", run.err);
        (start.elapsed(), run.err)
    };
    let (time, stderr) = took("--view --quiet");
    assert!(time < Duration::from_secs(2), "{time:?}");
    // The only message that `--quiet` shows.
    assert!(
        stderr.starts_with("note: live view: http://127.0.0.1:"),
        "{stderr}"
    );
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
}

#[test]
fn a_tab_that_reads_nothing_delays_the_end_for_a_moment() {
    let mut rendering = Rendering::start("--spp 20000 --checkpoint off -o a.exr");
    Tab::new(rendering.port, 7).state(|state| state["phase"] != "rendering");
    let start = Instant::now();
    let (code, stderr) = rendering.end();
    assert_eq!(code, Some(0), "{stderr}");
    assert!(
        start.elapsed() < Duration::from_secs(5),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn stopping_is_like_ctrl_c() {
    let mut rendering = Rendering::start(ENDLESS);
    let port = rendering.port;
    Tab::new(port, 1).state(|state| !state["picture"].is_null());
    assert_eq!(stop(port).map(|answer| answer.status), Some(204));
    let start = Instant::now();
    let (code, stderr) = rendering.end();
    assert_eq!(code, Some(130), "{stderr}");
    assert!(start.elapsed() < PATIENCE / 2);
    assert!(
        stderr.contains("note: continue with --resume, which reads a.vkpt"),
        "{stderr}"
    );
    assert_eq!(
        names(rendering.folder.path()),
        ["a.exr", "a.vkpt", "scene.scn"]
    );
}

#[test]
fn several_devices_are_looked_at_as_one_is() {
    let mut rendering = Rendering::on("cpu-f32,cpu-f32", 0, ENDLESS);
    let port = rendering.port;
    let state = Tab::new(port, 1).state(|state| state["picture"]["number"].as_u64() > Some(1));
    assert!(state["samples"].as_u64() > Some(0), "{state}");
    stop(port);
    let (code, stderr) = rendering.end();
    assert_eq!(code, Some(130), "{stderr}");
    assert_eq!(rendering.picture("a.exr").rgb.len(), 16 * 12);
}
