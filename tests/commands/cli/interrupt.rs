//! Signals that end a rendering: the picture is that of as many samples as were done.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use super::program::{command, folder, names, run};

/// A rendering that would take days.
const ENDLESS: [&str; 9] = [
    "scene.scn",
    "--device",
    "cpu-f32",
    "--spp",
    "4000000000",
    "-o",
    "a.exr",
    "--json",
    "a.json",
];

const SCENE: &str = "screen 16 12\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

pub fn send(id: u32, signal: &str) {
    let kill = format!("kill -{signal} {id}");
    let sent = Command::new("sh").args(["-c", &kill]).status();
    assert!(sent.expect("sh runs").success());
}

/// Sends a signal and waits, at most half a minute.
fn interrupt(mut child: Child, signal: &str) -> Option<ExitStatus> {
    send(child.id(), signal);
    let start = Instant::now();
    while start.elapsed() < Duration::from_secs(30) {
        if let Some(status) = child.try_wait().expect("a child") {
            return Some(status);
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    child
        .kill()
        .and_then(|()| child.wait())
        .expect("a child that can be killed");
    None
}

/// Interrupts a rendering that has begun: one that was met before it listens, or before its first sample, left
/// nothing, and the next is given more time.
fn interrupted(folder: &Path, signal: &str, code: i32) {
    for delay in [0.25, 0.5, 1.0, 2.0, 4.0, 8.0] {
        let mut endless = command(folder, &ENDLESS);
        let child = endless
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("it runs");
        std::thread::sleep(Duration::from_secs_f64(delay));
        let status = interrupt(child, signal);
        if folder.join("a.json").exists() {
            assert_eq!(status.and_then(|status| status.code()), Some(code));
            return;
        }
        // One that was signalled before it listened ended at once, and left its claims, which block no other.
        let locks = [".vkpt-a.exr.lock", ".vkpt-a.json.lock"];
        if status.is_some_and(|status| status.code().is_none()) {
            let remove = |lock| drop(fs::remove_file(folder.join(lock)));
            locks.into_iter().for_each(remove);
        }
        assert_eq!(names(folder), ["scene.scn"]);
    }
    panic!("no rendering began within seconds");
}

#[test]
fn the_picture_is_that_of_the_samples_done() {
    let folder = folder(SCENE);
    interrupted(folder.path(), "INT", 130);
    assert_eq!(
        names(folder.path()),
        ["a.exr", "a.json", "a.vkpt", "scene.scn"]
    );
    let text = fs::read_to_string(folder.path().join("a.json")).expect("a report");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["spp_asked"], 4_000_000_000u64);
    let spp = json["spp"].as_u64().expect("a number of samples");
    assert_eq!(json["samples"].as_u64(), Some(16 * 12 * spp));

    let spp = spp.to_string();
    let again = run(
        folder.path(),
        &[
            "scene.scn",
            "--device",
            "cpu-f32",
            "--spp",
            &spp,
            "-o",
            "b.exr",
        ],
    );
    assert_eq!(again.code, Some(0), "{}", again.err);
    let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a picture");
    assert!(
        bytes("a.exr") == bytes("b.exr"),
        "not the picture of --spp {spp}"
    );
}

/// Batch systems send SIGTERM before they kill; a terminal that is closed sends SIGHUP.
#[test]
fn other_signals_end_it_as_ctrl_c_does() {
    for (signal, code) in [("TERM", 143), ("HUP", 129)] {
        let folder = folder(SCENE);
        interrupted(folder.path(), signal, code);
        assert_eq!(
            names(folder.path()),
            ["a.exr", "a.json", "a.vkpt", "scene.scn"]
        );
    }
}

/// `nohup` starts a program with SIGHUP ignored, and a shell its background jobs with SIGINT ignored.
#[cfg(target_os = "linux")]
#[test]
fn signals_that_were_ignored_stay_so() {
    let folder = folder(SCENE);
    let program = command(folder.path(), &ENDLESS);
    let words: Vec<_> = [program.get_program()]
        .into_iter()
        .chain(program.get_args())
        .collect();
    let words: Vec<_> = words
        .iter()
        .map(|word| format!("'{}'", word.to_string_lossy()))
        .collect();
    let mut shell = Command::new("sh");
    let child = shell
        .current_dir(folder.path())
        .args(["-c", &format!("trap '' HUP INT; exec {}", words.join(" "))])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("a shell");
    // Long enough for the program to listen, and so to be ended if it did not keep them ignored.
    let id = child.id();
    for signal in ["HUP", "INT", "HUP"] {
        std::thread::sleep(Duration::from_secs(1));
        send(id, signal);
    }
    std::thread::sleep(Duration::from_secs(1));
    let status = interrupt(child, "TERM");
    assert_eq!(status.and_then(|status| status.code()), Some(143));
}
