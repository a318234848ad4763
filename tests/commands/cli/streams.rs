//! `-` for stdin and stdout: the output is the file, the whole file and only the file.

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::process::{Output, Stdio};

use insta::assert_snapshot;
use serde_json::Value;

use super::program::{MESH, SCENE, command, folder, names, run, shown, without_vulkan};

/// Runs with a text as stdin.
fn piped(folder: &Path, arguments: &[&str], stdin: &str) -> Output {
    let mut command = command(folder, arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.stderr(Stdio::piped()).spawn().expect("a process");
    let mut input = child.stdin.take().expect("a pipe");
    // A program that refuses its flags reads nothing.
    let _ = input.write_all(stdin.as_bytes());
    drop(input);
    child.wait_with_output().expect("the program runs")
}

/// stderr.
fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// `vkpt scene.scn` by the reference, two samples a pixel.
fn rendering<'a>(flags: &[&'a str]) -> Vec<&'a str> {
    [
        &["scene.scn", "--device", "cpu-f32", "--spp", "2"][..],
        flags,
    ]
    .concat()
}

#[test]
fn a_picture_on_stdout_is_that_of_the_file() {
    let folder = folder(SCENE);
    for format in ["png", "hdr", "exr"] {
        let name = format!("file.{format}");
        run(folder.path(), &rendering(&["-o", &name]));
        let file = fs::read(folder.path().join(&name)).expect("a picture");
        let flags = rendering(&["-o", "-", "--format", format]);
        let output = piped(folder.path(), &flags, "");
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(output.stdout == file && !file.is_empty(), "{format}");
        let printed = stderr(&output);
        assert!(
            printed.starts_with("scene.scn: 8×6, 2 samples"),
            "{printed}"
        );
        assert!(
            printed.contains("\n  wrote   stdout\n2 spp · "),
            "{printed}"
        );
        let quiet = piped(folder.path(), &[&flags[..], &["--quiet"]].concat(), "");
        assert!(quiet.stdout == file && quiet.stderr.is_empty(), "{format}");
    }
    assert_eq!(
        names(folder.path()),
        ["file.exr", "file.hdr", "file.png", "scene.scn"]
    );
}

/// The flag decides where the name does not, and for pictures without their own name.
#[test]
fn the_format_of_a_file_is_that_of_its_name_or_of_the_flag() {
    let folder = folder(SCENE);
    let exr = |name: &str| {
        let bytes = fs::read(folder.path().join(name)).expect("a picture");
        bytes.starts_with(b"\x76\x2f\x31\x01")
    };
    let ran = run(folder.path(), &rendering(&["--format", "exr"]));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_eq!(names(folder.path()), ["scene.exr", "scene.scn"]);
    let flags = rendering(&["-o", "frame.0001", "-o", "a.png", "--format", "exr"]);
    assert_eq!(run(folder.path(), &flags).code, Some(0));
    assert!(exr("scene.exr") && exr("frame.0001") && !exr("a.png"));
}

#[test]
fn a_report_on_stdout_is_all_there_is_on_it() {
    let folder = folder(SCENE);
    let output = piped(
        folder.path(),
        &rendering(&["--json", "-", "-o", "a.png"]),
        "",
    );
    assert_eq!(output.status.code(), Some(0));
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(
        (&json["spp"], &json["files"][0]),
        (&2.into(), &"a.png".into())
    );
    assert!(
        stderr(&output).contains("wrote   a.png"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn every_report_of_an_experiment_can_go_to_stdout() {
    let folder = folder(SCENE);
    // References take as long as the experiment may.
    let common = "converge scene.scn --device cpu-f32 --spp 1 --time 0.5";
    let common: Vec<&str> = common.split(' ').collect();
    let on_stdout = |flag: &str| {
        let output = piped(folder.path(), &[&common[..], &[flag, "-"]].concat(), "");
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(
            stderr(&output).contains("8 replicates"),
            "{}",
            stderr(&output)
        );
        String::from_utf8(output.stdout).expect("a text")
    };
    let csv = on_stdout("--csv");
    assert!(csv.starts_with("variant,spp,") && csv.lines().count() == 2);
    let json: Value = serde_json::from_str(&on_stdout("--json")).expect("JSON");
    assert_eq!(json["scene"], "scene.scn");
    for (flag, root) in [("--svg", "svg"), ("--html", "html")] {
        let page = on_stdout(flag).to_lowercase();
        assert!(page.starts_with("<svg") || page.starts_with("<!doctype html"));
        assert!(page.trim_end().ends_with(&format!("</{root}>")), "{flag}");
    }
    assert_eq!(names(folder.path()), ["scene.scn"]);
}

#[test]
fn a_kernel_and_a_heat_map_on_stdout_are_those_of_the_files() {
    let folder = folder(SCENE);
    let read = |name: &str| fs::read(folder.path().join(name)).expect("a file");
    for name in ["a.exr", "b.exr"] {
        run(folder.path(), &rendering(&["-o", name, "--seed", "7"]));
    }
    let rows: [(&[&str], &str, &str); 2] = [
        (
            &["explain", "scene.scn", "--spirv"],
            "k.spv",
            "Not in the kernel",
        ),
        (
            &["compare", "a.exr", "b.exr", "--heatmap"],
            "k.png",
            "relMSE",
        ),
    ];
    for (arguments, name, message) in rows {
        run(folder.path(), &[arguments, &[name]].concat());
        let output = piped(folder.path(), &[arguments, &["-"]].concat(), "");
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(output.stdout == read(name), "{name}");
        assert!(stderr(&output).contains(message), "{}", stderr(&output));
    }
}

#[test]
fn a_check_and_an_examination_report_to_stdout() {
    if without_vulkan() {
        return;
    }
    let folder = folder("");
    let rows: [(&[&str], &str, &str); 2] = [
        (
            &["check", "--case", "camera/one-pixel", "--json", "-"],
            "passed",
            "1 case, none fails",
        ),
        (&["doctor", "--json", "-"], "verdict", ": healthy"),
    ];
    for (arguments, member, message) in rows {
        let output = piped(folder.path(), arguments, "");
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert!(!json[member].is_null(), "{member}");
        assert!(stderr(&output).contains(message), "{}", stderr(&output));
    }
}

#[test]
fn a_scene_from_stdin_is_that_of_the_file() {
    let scene = format!("{SCENE}mesh in/a.ply 0 0 0 1\n");
    let folder = folder(&scene);
    fs::create_dir(folder.path().join("in")).expect("a folder");
    fs::write(folder.path().join("in/a.ply"), MESH).expect("a mesh");
    let png = |name: &str| fs::read(folder.path().join(name)).expect("a picture");
    run(folder.path(), &rendering(&[]));
    let flags = [&["-"], &rendering(&[])[1..]].concat();
    let output = piped(folder.path(), &flags, &scene);
    assert_eq!(
        (output.status.code(), stderr(&output).as_str()),
        (Some(0), "")
    );
    let out = String::from_utf8(output.stdout).expect("a text");
    assert!(out.starts_with("<stdin>: 8×6, 2 samples"), "{out}");
    assert!(out.contains("wrote   stdin.png, stdin.exr\n"), "{out}");
    assert_eq!(png("stdin.png"), png("scene.png"));
}

/// The output of other commands about a scene is the same, except for its name.
#[test]
fn every_command_that_takes_a_scene_reads_stdin() {
    let folder = folder(SCENE);
    let mut rows: Vec<&[&str]> = vec![
        &["explain", "SCENE"],
        &["explain", "SCENE", "--glsl"],
        &["SCENE", "--trace", "4,3,0", "--device", "cpu-f32"],
        // Two models: the scene is prepared twice and read once.
        &[
            "converge",
            "SCENE",
            "--device",
            "cpu-f32",
            "--spp",
            "1",
            "--time",
            "0.5",
            "--vary",
            "absorption=segment,term",
        ],
    ];
    if !without_vulkan() {
        rows.push(&["compare", "--paired", "SCENE", "--spp", "1"]);
    }
    for row in rows {
        let with = |name: &str| {
            let arguments = row
                .iter()
                .map(|word| if *word == "SCENE" { name } else { word });
            let output = piped(folder.path(), &arguments.collect::<Vec<_>>(), SCENE);
            assert_eq!(
                output.status.code(),
                Some(0),
                "{row:?}: {}",
                stderr(&output)
            );
            String::from_utf8(output.stdout).expect("a text")
        };
        let (file, stdin) = (with("scene.scn"), with("-"));
        let lines = |text: &str| text.lines().count();
        match row[0] {
            // Its figures are seconds.
            "converge" => assert_eq!(lines(&stdin), lines(&file), "{stdin}"),
            _ => assert_eq!(stdin, file.replace("scene.scn", "<stdin>"), "{row:?}"),
        }
    }
    assert_eq!(names(folder.path()), ["scene.scn"]);
}

#[test]
fn errors_in_a_scene_from_stdin_name_it_and_the_line() {
    let folder = folder("");
    let output = piped(folder.path(), &["-"], &format!("{SCENE}sphere 0 0 0 -1\n"));
    assert_eq!(output.status.code(), Some(3));
    let empty = piped(folder.path(), &["explain", "-"], "");
    assert_eq!(empty.status.code(), Some(3));
    assert_snapshot!(stderr(&output) + &stderr(&empty));
    assert_eq!(names(folder.path()), ["scene.scn"]);
}

#[test]
fn outputs_that_stdout_cannot_take_are_refused_before_the_work() {
    let folder = folder(SCENE);
    let lines = [
        "scene.scn -o -",
        "scene.scn -o a.exr --format png",
        "scene.scn -o - --format png --json -",
        "scene.scn -o - -o - --format png",
        "scene.scn -o a.png --json ./a.png",
        "scene.scn -o - --format exr --aov stderr",
        "converge - --csv - --html -",
        "check --json - --html -",
        "explain scene.scn --glsl --spirv -",
    ];
    let messages = lines.map(|line| {
        let arguments: Vec<&str> = line.split(' ').collect();
        let output = piped(folder.path(), &arguments, SCENE);
        assert_eq!(output.status.code(), Some(2), "{line}");
        assert!(output.stdout.is_empty(), "{line}");
        assert_eq!(names(folder.path()), ["scene.scn"], "{line}");
        shown(&arguments, &stderr(&output))
    });
    assert_snapshot!(messages.concat());
}

/// A device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn a_stdout_that_cannot_be_written_is_5() {
    let folder = folder(SCENE);
    let picture = rendering(&["-o", "-", "--format", "exr"]);
    let report = rendering(&["-o", "a.png", "--json", "-"]);
    let summary = rendering(&["-o", "b.png"]);
    let trace = rendering(&["--trace", "4,3,0"]);
    let mut rows: Vec<&[&str]> = vec![
        &picture,
        &report,
        &summary,
        &trace,
        &["explain", "scene.scn"],
        &["explain", "scene.scn", "--glsl"],
        &["explain", "scene.scn", "--spirv", "-"],
        &["export", "scene.scn", "--to", "mitsuba", "-o", "-"],
        &["compare", "b.png", "b.png"],
        &["compare", "b.png", "b.png", "--heatmap", "-"],
        &[
            "converge",
            "scene.scn",
            "--device",
            "cpu-f32",
            "--spp",
            "1",
            "--time",
            "0.1",
        ],
        &["--help"],
        &["--version"],
        &["explain", "--help"],
    ];
    if !without_vulkan() {
        rows.push(&["devices"]);
        rows.push(&["doctor"]);
        rows.push(&["check", "--case", "camera/one-pixel"]);
        rows.push(&["compare", "--paired", "scene.scn", "--spp", "1"]);
    }
    for arguments in rows {
        let full = File::create("/dev/full").expect("Linux has it");
        let mut command = command(folder.path(), arguments);
        let output = command.stdout(full).output().expect("the program runs");
        assert_eq!(output.status.code(), Some(5), "{arguments:?}");
        let printed = stderr(&output);
        assert!(
            printed.contains("error: cannot write stdout: "),
            "{printed}"
        );
    }
    // An output with its own file is written there.
    assert_eq!(names(folder.path()), ["a.png", "b.png", "scene.scn"]);
}

/// A reader that goes away has read enough.
#[test]
fn a_broken_pipe_ends_quietly() {
    let folder = folder(SCENE);
    let picture = rendering(&["-o", "-", "--format", "png", "--quiet"]);
    let summary = rendering(&["-o", "a.png"]);
    let rows: [&[&str]; 5] = [
        &picture,
        &summary,
        &["explain", "scene.scn", "--glsl"],
        &["--help"],
        &["--version"],
    ];
    for arguments in rows {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let mut command = command(folder.path(), arguments);
        let output = command.stdout(writer).output().expect("the program runs");
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert_eq!(stderr(&output), "", "{arguments:?}");
    }
    // The reader of the messages does not matter either.
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let mut refused = command(folder.path(), &["none.scn"]);
    let status = refused.stderr(writer).status().expect("the program runs");
    assert_eq!(status.code(), Some(3));
}
