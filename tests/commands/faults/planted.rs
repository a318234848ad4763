//! The harness itself: it finds the planted mistakes of programs.

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use super::expected;
use super::trial::{Trial, finish, finish_within};

/// A line of the shell instead of the program.
fn shell(line: &str) -> impl FnOnce(&Path) -> Command {
    move |folder| {
        let mut shell = Command::new("sh");
        shell.current_dir(folder).args(["-c", line]);
        shell.env("VKPT", env!("CARGO_BIN_EXE_vkpt"));
        shell
    }
}

/// The device is lost twice.
const FAULT: &str = "vkQueueSubmit:1:-4,vkQueueSubmit:2:-4";

fn verdict(line: &str, sound: &Trial) -> Result<(), String> {
    expected::check(FAULT, &finish(shell(line)), sound)
}

const RENDER: &str =
    "$VKPT scene.scn --device cpu-f32 --quiet -o a.exr --json a.json --checkpoint off --spp";

#[test]
fn expected_ends_pass() {
    let sound = finish(shell(&format!("{RENDER} 64")));
    assert_eq!(sound.code, Some(0), "{}", sound.err);
    for line in [
        format!("{RENDER} 64"),
        "echo 'error: the device was lost' >&2; exit 7".to_owned(),
        format!("{RENDER} 1 -o a.vkpt; echo 'error: vkQueueSubmit failed' >&2; exit 7"),
    ] {
        assert_eq!(verdict(&line, &sound), Ok(()), "{line}");
    }
}

#[test]
fn wrong_ends_are_found() {
    let sound = finish(shell(&format!("{RENDER} 64")));
    let lost = "echo 'error: the device was lost' >&2";
    for (line, why) in [
        ("exit 101".to_owned(), "a panic"),
        (
            format!("echo thread main panicked at >&2; {lost}; exit 7"),
            "a panic",
        ),
        ("kill -SEGV $$".to_owned(), "a signal"),
        (format!("{RENDER} 1"), "another picture"),
        (format!("{RENDER} 64; rm a.json"), "no report"),
        ("exit 0".to_owned(), "another picture"),
        ("exit 1".to_owned(), "no word of what failed"),
        (
            "echo 'error: it failed' >&2; exit 1".to_owned(),
            "no word of what failed",
        ),
        (format!("{lost}; exit 5"), "the wrong exit code"),
        (format!("{lost}; exit 1"), "the wrong exit code"),
        (
            format!("{RENDER} 1 -o a.vkpt; printf old > a.exr; rm a.json; {lost}; exit 7"),
            "without a picture",
        ),
        (
            format!("{RENDER} 1; {lost}; exit 7"),
            "nothing to go on from",
        ),
        (
            format!("{RENDER} 1 --seed 1 -o a.vkpt; {lost}; exit 7"),
            "another picture",
        ),
        (
            format!("rm a.exr; {lost}; exit 7"),
            "the old picture is gone",
        ),
        (
            format!("{RENDER} 2; truncate -s 300 a.exr; {lost}; exit 7"),
            "a broken picture",
        ),
        (
            format!("{RENDER} 2; truncate -s 90 a.json; {lost}; exit 7"),
            "a broken report",
        ),
        (
            format!("touch .vkpt-x; {lost}; exit 7"),
            ".vkpt-x lies about",
        ),
    ] {
        let found = verdict(&line, &sound);
        let found = found.expect_err(&line);
        assert!(found.contains(why), "{line}: {found}");
    }
    let wrote = finish(shell(&format!(
        "{RENDER} 1; echo 'error: vkCreateDevice' >&2; exit 1"
    )));
    let found = expected::check("vkCreateDevice:1:-3", &wrote, &sound);
    assert_eq!(found, Err("it failed, and wrote".to_owned()));
    let sleeps = finish_within(Duration::from_millis(200), shell("exec sleep 60"));
    let found = expected::check(FAULT, &sleeps, &sound);
    assert_eq!(found, Err("it hangs".to_owned()));
}
