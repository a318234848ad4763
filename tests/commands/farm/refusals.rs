//! `vkpt farm slurm`: the folders that it leaves, its refusals, and its messages if Slurm is missing.

use std::fs;
use std::process::Command;

use crate::cli::program::{MESHED, SCENE, command, finish, folder, names, run, words};

const FILES: [&str; 6] = [
    "farm.sh",
    "merge.sbatch",
    "part.sbatch",
    "parts.txt",
    "round",
    "submit.sh",
];

#[test]
fn each_scene_gets_a_folder_that_says_how_to_submit_it() {
    let folder = folder(SCENE);
    fs::create_dir(folder.path().join("shots")).expect("a folder");
    fs::write(folder.path().join("shots/b.1.txt"), SCENE).expect("a scene");
    let made = words(
        folder.path(),
        "farm slurm scene.scn shots/b.1.txt --spp 1024 --tasks 4",
    );
    assert_eq!((made.code, made.err.as_str()), (Some(0), ""));
    assert_eq!(
        names(folder.path()),
        ["b.1.farm", "scene.farm", "scene.scn", "shots"]
    );
    for name in ["scene.farm", "b.1.farm"] {
        assert_eq!(names(&folder.path().join(name)), FILES);
        let submit = format!("{name}/submit.sh");
        assert!(made.out.contains(&submit), "{}", made.out);
    }
    let parts = fs::read_to_string(folder.path().join("scene.farm/parts.txt")).expect("a text");
    assert_eq!(parts, "1 0 256\n1 256 512\n1 512 768\n1 768 1024\n");
}

#[test]
fn scripts_are_written_again_until_parts_are_there() {
    let folder = folder(SCENE);
    let farm = |spp: &str| run(folder.path(), &["farm", "slurm", "scene.scn", "--spp", spp]);
    assert_eq!([farm("8").code, farm("9").code], [Some(0), Some(0)]);
    let parts = folder.path().join("scene.farm/parts");
    fs::create_dir(&parts).expect("a folder");
    let refused = farm("8");
    assert_eq!((refused.code, refused.out.as_str()), (Some(2), ""));
    for message in ["continue it with", "remove the folder"] {
        assert!(refused.err.contains(message), "{}", refused.err);
    }
    let text = fs::read_to_string(parts.with_file_name("parts.txt")).expect("a text");
    assert_eq!(text, "1 0 9\n");
}

#[test]
fn scenes_that_cannot_be_rendered_leave_no_folder() {
    let folder = folder(SCENE);
    for (name, text) in [
        ("wrong.txt", "sphere 0"),
        ("100%.txt", SCENE),
        ("mesh.txt", MESHED),
    ] {
        fs::write(folder.path().join(name), text).expect("a scene");
    }
    fs::create_dir(folder.path().join("more")).expect("a folder");
    fs::write(folder.path().join("more/scene.txt"), SCENE).expect("a scene");
    let before = names(folder.path());
    for (line, code, message) in [
        ("-", 2, "write it to a file"),
        ("scene.scn more/scene.txt -o a.exr", 2, "omit it"),
        ("scene.scn more/scene.txt", 2, "two scenes"),
        ("scene.scn --tasks 65", 2, "--spp 64"),
        ("scene.scn --tasks 10001 --spp 20000", 2, "at most 10000"),
        ("scene.scn --tasks 0", 2, "from 1 to"),
        ("scene.scn -o a.txt", 2, ".png, .hdr, .exr or .vkpt"),
        ("scene.scn -o -", 2, "-o stdout: the ending must be"),
        ("scene.scn -o none/a.exr", 5, "none/a.exr"),
        ("scene.scn --max-depth -1", 2, "whole number"),
        (
            "scene.scn --integrator light --absorption term",
            2,
            "--absorption term",
        ),
        ("100%.txt", 2, "-o"),
        ("wrong.txt", 3, "error"),
        ("mesh.txt", 3, "m.ply"),
        ("", 2, "<SCENE>"),
    ] {
        let all = format!("farm slurm {line}");
        let refused = words(folder.path(), all.trim_end());
        assert_eq!(
            (refused.code, refused.out.as_str()),
            (Some(code), ""),
            "{line}: {}",
            refused.err
        );
        assert!(refused.err.contains(message), "{line}: {}", refused.err);
        assert_eq!(names(folder.path()), before, "{line}");
    }
}

#[test]
fn without_slurm_the_scripts_are_there_and_a_message_says_so() {
    let folder = folder(SCENE);
    let bin = folder.path().join("bin");
    fs::create_dir(&bin).expect("a folder");
    for name in ["bash", "dirname"] {
        let found = Command::new("bash")
            .args(["-c", &format!("command -v {name}")])
            .output();
        let found = String::from_utf8(found.expect("bash runs").stdout).expect("UTF-8");
        std::os::unix::fs::symlink(found.trim_end(), bin.join(name)).expect("a link");
    }
    let refused = finish(
        command(folder.path(), &["farm", "slurm", "scene.scn", "--submit"]).env("PATH", &bin),
    );
    assert_eq!((refused.code, refused.out.as_str()), (Some(1), ""));
    assert!(
        refused
            .err
            .contains("submit.sh: sbatch is not installed here"),
        "{}",
        refused.err
    );
    assert_eq!(refused.err.lines().count(), 1, "{}", refused.err);
    assert_eq!(names(&folder.path().join("scene.farm")), FILES);
}
