//! `--checkpoint` and `--resume`: a rendering continues to the same bits, however it was ended.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use insta::assert_snapshot;
use serde_json::Value;

use super::program::{command, folder, names, run, shown, words};

/// About 20 µs a sample of the whole picture.
const SCENE: &str = "screen 4 3\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

const COMMON: &str = "scene.scn --device cpu-f32 --quiet";

fn spawn(folder: &Path, line: &str) -> Child {
    let words: Vec<&str> = line.split(' ').collect();
    let mut command = command(folder, &words);
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::piped());
    quiet.spawn().expect("it runs")
}

fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Kills a rendering again and again after some milliseconds, and resumes it each time; at its end, the files are those of
/// a rendering that was not killed.
fn killed(times: u32, spp: u32, more: &str) {
    let folder = folder(SCENE);
    let path = folder.path();
    let line = format!("{COMMON} --spp {spp} --checkpoint 0.002{more}");
    let one = words(path, &format!("{line} -o one.exr --json one.json"));
    assert_eq!(one.code, Some(0), "{}", one.err);
    let again = format!("{line} -o a.exr --resume --json a.json");
    // Splitmix's odd constant: moments of 1 to 60 ms, spread evenly.
    let moment = |i: u32| u64::from(i.wrapping_mul(0x9e37_79b9)) % 60 + 1;
    let mut alive = 0;
    for i in 0..times {
        let mut child = spawn(path, &again);
        std::thread::sleep(Duration::from_millis(moment(i)));
        child.kill().expect("SIGKILL");
        let status = child.wait().expect("a child");
        alive += u32::from(status.code().is_none());
        // The file on disk is whole: the next run reads it, or refuses it with 3.
        let there = names(path);
        let ours = ["a.", "a-stderr.", "one.", "one-stderr.", "scene.scn", "."];
        let known = |name: &String| ours.iter().any(|start| name.starts_with(start));
        assert!(there.iter().all(known), "{there:?}");
    }
    assert!(
        alive > times / 2,
        "{alive} of {times} were killed: the rendering is too short"
    );
    let last = words(path, &again);
    assert_eq!(last.code, Some(0), "{}", last.err);
    assert!(
        bytes(path, "a.exr") == bytes(path, "one.exr"),
        "another picture"
    );
    let report = |name| -> Value { serde_json::from_slice(&bytes(path, name)).expect("JSON") };
    let [a, b] = ["a.json", "one.json"].map(report);
    for field in ["spp", "samples", "rays", "largest", "dropped"] {
        assert_eq!(a[field], b[field], "{field}");
    }
    let errors = |report: &Value| -> Vec<(Value, Value)> {
        let all = report["error"].as_array().expect("a list");
        all.iter()
            .map(|e| (e["spp"].clone(), e["high"].clone()))
            .collect()
    };
    assert_eq!(errors(&a), errors(&b));
}

#[test]
fn a_killed_rendering_goes_on_to_the_same_bits() {
    killed(25, 40_000, "");
}

#[test]
#[ignore = "a minute or two: a hundred of each integrator"]
fn renderings_killed_a_hundred_times_go_on_to_the_same_bits() {
    killed(100, 150_000, "");
    killed(100, 20_000, " --integrator bidirectional");
    killed(100, 100_000, " --sampler random --aov stderr");
}

/// Picture and part: a rendering resumes from the files that SIGTERM, SIGHUP and ctrl-c leave.
#[test]
fn a_signal_leaves_a_part_to_go_on_from() {
    for (signal, code) in [("TERM", 143), ("HUP", 129), ("INT", 130)] {
        let folder = folder(SCENE);
        let path = folder.path();
        let child = spawn(path, "scene.scn --device cpu-f32 --spp 4000000000 -o a.exr");
        std::thread::sleep(Duration::from_millis(1500));
        super::interrupt::send(child.id(), signal);
        let ended = child.wait_with_output();
        let ended = ended.expect("a child");
        assert_eq!(ended.status.code(), Some(code));
        let stderr = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert!(
            stderr.contains("note: continue with --resume, which reads a.vkpt"),
            "{stderr}"
        );
        assert_eq!(names(path), ["a.exr", "a.vkpt", "scene.scn"]);
        // A few samples more.
        let (header, [_, done], _) =
            vkpt::state::read_header(&path.join("a.vkpt")).expect("a part");
        assert_eq!(header.record.job.ended, "interrupted");
        let spp = done + 300;
        let resumed = words(path, &format!("{COMMON} --spp {spp} --resume -o a.exr"));
        assert_eq!((resumed.code, &*resumed.err), (Some(0), ""));
        let anew = words(path, &format!("{COMMON} --spp {spp} -o b.exr"));
        assert_eq!(anew.code, Some(0));
        assert!(bytes(path, "a.exr") == bytes(path, "b.exr"));
        // The part is kept true.
        let (_, [_, done], _) = vkpt::state::read_header(&path.join("a.vkpt")).expect("a part");
        assert_eq!(done, spp);
    }
}

#[test]
fn a_second_signal_ends_it_at_once() {
    let folder = folder(SCENE);
    // One slice of samples of this size takes minutes.
    let line =
        "scene.scn --device cpu-f64 --size 8000x6000 --integrator bidirectional --spp 9 -o a.exr";
    let mut child = spawn(folder.path(), line);
    std::thread::sleep(Duration::from_millis(2500));
    let start = Instant::now();
    super::interrupt::send(child.id(), "TERM");
    std::thread::sleep(Duration::from_millis(300));
    super::interrupt::send(child.id(), "TERM");
    let status = child.wait().expect("a child");
    assert_eq!(status.code(), Some(143));
    assert!(start.elapsed() < Duration::from_secs(20));
    assert!(!folder.path().join("a.exr").exists());
}

#[test]
fn it_goes_on_to_other_ends() {
    // Of twelve pixels there is no honest interval.
    let folder = folder(&SCENE.replace("screen 4 3", "screen 16 12"));
    let path = folder.path();
    let ok = |line: &str| {
        let run = words(path, line);
        assert_eq!(run.code, Some(0), "{line}: {}", run.err);
        run.err
    };
    ok(&format!("{COMMON} --spp 20 -o a.vkpt -o a.exr"));
    ok(&format!("{COMMON} --spp 70 --resume -o a.vkpt -o a.exr"));
    ok(&format!("{COMMON} --spp 70 -o b.exr"));
    assert!(bytes(path, "a.exr") == bytes(path, "b.exr"));
    // By error: as a rendering that was never interrupted.
    ok(&format!(
        "{COMMON} --target-error 4e-7 --resume -o a.vkpt -o a.exr --json a.json"
    ));
    ok(&format!(
        "{COMMON} --target-error 4e-7 -o b.exr --json b.json"
    ));
    let spp = |name| -> Value {
        let report: Value = serde_json::from_slice(&bytes(path, name)).expect("JSON");
        report["spp"].clone()
    };
    assert!(spp("a.json").as_u64() > Some(70));
    assert_eq!(spp("a.json"), spp("b.json"));
    assert!(bytes(path, "a.exr") == bytes(path, "b.exr"));
    // By time: the seconds before count.
    ok(&format!(
        "{COMMON} --time 0.7 --resume -o a.vkpt --json a.json"
    ));
    let started = Instant::now();
    ok(&format!(
        "{COMMON} --time 0.7 --resume -o a.vkpt -o c.exr --json a.json"
    ));
    assert!(
        started.elapsed() < Duration::from_millis(600),
        "it began anew"
    );
    // Nothing exists so far.
    let stderr = ok(&format!("{COMMON} --spp 2 --resume -o new.exr"));
    assert!(
        stderr.contains("new.vkpt does not exist: rendering from the first sample"),
        "{stderr}"
    );
    // A part that is whole.
    ok(&format!("{COMMON} --samples 5..9 -o p.vkpt"));
    let stderr = ok(&format!("{COMMON} --samples 5..9 --resume -o p.vkpt"));
    assert!(
        stderr.contains("the file already contains all samples"),
        "{stderr}"
    );
}

#[test]
fn parts_of_another_rendering_are_not_resumed() {
    let folder = folder(SCENE);
    let path = folder.path();
    let first = words(path, &format!("{COMMON} --spp 300 -o a.vkpt"));
    assert_eq!(first.code, Some(0));
    let before = bytes(path, "a.vkpt");
    let lines = [
        "--device cpu-f32 --spp 400 --seed 1",
        "--device cpu-f32 --spp 200",
        "--device cpu-f32 --samples 100..400",
        "--device cpu-f64 --spp 400",
        "--device cpu-f32 --spp 400 --aov stderr --sampler random -o a.exr",
    ];
    let mut messages = String::new();
    for flags in lines {
        let line = format!("scene.scn --quiet {flags} --resume -o a.vkpt");
        let run = words(path, &line);
        assert_eq!(run.code, Some(3), "{flags}: {}", run.err);
        assert!(bytes(path, "a.vkpt") == before, "{flags}");
        messages += &shown(&line.split(' ').collect::<Vec<_>>(), &run.err);
    }
    fs::write(path.join("a.vkpt"), "mine").expect("written");
    let run = words(path, &format!("{COMMON} --spp 400 --resume -o a.vkpt"));
    assert_eq!(run.code, Some(3));
    assert_eq!(bytes(path, "a.vkpt"), b"mine");
    assert_snapshot!(messages + "a.vkpt: mine\n" + &run.err);
}

/// A user who forgets `--resume` gets a message before the samples are overwritten.
#[test]
fn a_part_that_could_be_resumed_is_pointed_out() {
    let folder = folder(SCENE);
    let path = folder.path();
    let part = words(path, &format!("{COMMON} --spp 300 -o a.vkpt"));
    assert_eq!(part.code, Some(0));
    let printed = run(
        path,
        &[
            "scene.scn",
            "--device",
            "cpu-f32",
            "--spp",
            "400",
            "-o",
            "a.exr",
        ],
    );
    let message = "note: a.vkpt contains 300 samples per pixel of this rendering: continue from them with --resume";
    assert!(printed.err.contains(message), "{}", printed.err);
    let other = run(
        path,
        &[
            "scene.scn",
            "--device",
            "cpu-f32",
            "--seed",
            "2",
            "-o",
            "a.exr",
        ],
    );
    assert!(!other.err.contains("--resume"), "{}", other.err);
}

/// A rendering that is over before the first checkpoint leaves none, and `off` leaves none at all.
#[test]
fn short_renderings_leave_pictures_alone() {
    let folder = folder(SCENE);
    let path = folder.path();
    for more in ["--spp 100", "--spp 20000 --checkpoint off"] {
        let run = words(path, &format!("{COMMON} {more} -o a.exr"));
        assert_eq!(run.code, Some(0));
        assert_eq!(names(path), ["a.exr", "scene.scn"]);
    }
    let run = words(
        path,
        &format!("{COMMON} --spp 20000 --checkpoint 0.01 -o a.exr"),
    );
    assert_eq!(run.code, Some(0));
    assert_eq!(names(path), ["a.exr", "a.vkpt", "scene.scn"]);
}

#[test]
fn a_rendering_goes_on_where_no_checkpoint_can_be_written() {
    let folder = folder(SCENE);
    let path = folder.path();
    // A folder of that name is in the way.
    fs::create_dir(path.join("a.vkpt")).expect("a folder");
    let run = words(path, &format!("{COMMON} --spp 3 -o a.exr"));
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert!(
        run.err
            .contains("warning: cannot write checkpoints: a.vkpt"),
        "{}",
        run.err
    );
    assert!(path.join("a.exr").is_file());
    let run = words(path, &format!("{COMMON} --spp 3 -o a.exr --resume"));
    assert_eq!(run.code, Some(5), "{}", run.err);
}
