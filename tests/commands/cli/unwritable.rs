//! Files that cannot be written, found out before the work.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

use super::program::{SCENE, command, finish, folder, names, without_vulkan, words};

const RENDER: &str = "scene.scn --device cpu-f32 --spp 2 --quiet";

/// Noticed before the first of 2³² samples, also for default names: no file can be made in /proc.
#[test]
fn a_folder_that_takes_no_files_is_an_error_before_the_work() {
    let folder = folder(SCENE);
    let scene = folder.path().join("scene.scn");
    let scene = scene.to_str().expect("a name");
    words(folder.path(), &format!("{RENDER} -o a.png"));
    let picture = folder.path().join("a.png");
    let picture = picture.to_str().expect("a name");
    let endless = ["--device", "cpu-f32", "--spp", "4294967295"];
    let mut rows: Vec<(Vec<&str>, &str)> = vec![
        ([&[scene][..], &endless].concat(), "scene.png"),
        ([&[scene, "-o", "b.hdr"][..], &endless].concat(), "b.hdr"),
        (
            [&["converge", scene, "--csv", "c.csv"][..], &endless].concat(),
            "c.csv",
        ),
        (
            vec!["compare", picture, picture, "--heatmap", "d.png"],
            "d.png",
        ),
        (vec!["explain", scene, "--spirv", "e.spv"], "e.spv"),
        (vec!["export", scene, "--to", "mitsuba"], "scene.xml"),
        (vec!["check", "--json", "f.json"], "f.json"),
    ];
    if !without_vulkan() {
        rows.push((vec!["doctor", "--json", "g.json"], "g.json"));
    }
    for (arguments, name) in rows {
        let ran = finish(command(Path::new("/proc"), &arguments).current_dir("/proc"));
        assert_eq!(ran.code, Some(5), "{arguments:?}: {}", ran.err);
        let message = format!("error: cannot write {name}: ");
        assert!(ran.err.starts_with(&message), "{arguments:?}: {}", ran.err);
        assert!(!ran.err.contains(".vkpt-"), "{}", ran.err);
        assert_eq!(ran.out, "", "{arguments:?}");
    }
}

/// Its folder would let another file take its place. Root may write it, and does.
#[test]
fn a_file_that_may_not_be_written_is_not_replaced() {
    let folder = folder(SCENE);
    let path = folder.path().join("a.exr");
    fs::write(&path, "old").expect("a file");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).expect("mode");
    let may = fs::OpenOptions::new().write(true).open(&path).is_ok();
    let ran = words(folder.path(), &format!("{RENDER} -o a.exr"));
    assert_eq!(ran.code, Some(if may { 0 } else { 5 }), "{}", ran.err);
    let kept = fs::read(&path).expect("a file") == b"old";
    assert_eq!(kept, !may);
    assert_eq!(names(folder.path()), ["a.exr", "scene.scn"]);
}

#[test]
fn names_that_no_file_can_have_are_errors_before_the_work() {
    let folder = folder(SCENE);
    let (most, more) = ("n".repeat(251) + ".exr", "n".repeat(252) + ".exr");
    let endless = RENDER.replace("--spp 2", "--spp 4294967295");
    let picture = format!("{endless} -o {most} --aov stderr");
    for (line, message) in [
        (format!("{endless} -o {more}"), "too long"),
        (picture, "n-stderr.exr: File name too long"),
        (
            format!("{endless} --json none/"),
            "cannot write none/: is not a file name",
        ),
        (format!("{endless} --json "), "is not a file name"),
        (
            format!("{endless} --json scene.scn/a"),
            "cannot write scene.scn/a: ",
        ),
    ] {
        let ran = words(folder.path(), &line);
        assert_eq!(ran.code, Some(5), "{}: {}", line, ran.err);
        assert!(ran.err.contains(message), "{}: {}", line, ran.err);
        assert_eq!(names(folder.path()), ["scene.scn"]);
    }
    // A part next to it would have a name that is longer by one.
    let ran = words(folder.path(), &format!("{RENDER} -o {most}"));
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(
        ran.err.starts_with("warning: cannot write checkpoints: n"),
        "{}",
        ran.err
    );
    let ran = words(
        folder.path(),
        &format!("{RENDER} -o {most} --checkpoint off"),
    );
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
}

/// A reader of a pipe would get both pictures in one.
#[test]
fn a_pipe_takes_one_output() {
    let folder = folder(SCENE);
    let pipe = std::process::Command::new("mkfifo")
        .arg(folder.path().join("p.exr"))
        .status();
    assert!(pipe.expect("mkfifo runs").success());
    let ran = words(folder.path(), &format!("{RENDER} -o p.exr -o ./p.exr"));
    assert_eq!(ran.code, Some(2));
    assert!(
        ran.err
            .contains("two outputs would be written to the same file"),
        "{}",
        ran.err
    );
}
