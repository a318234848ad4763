//! Runs in any environment: variables, closed streams, names of any bytes.

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;

use super::program::{MESH, MESHED, Run, SCENE, command, finish, folder, names, shell};

/// An experiment that looks for its reference in the cache, and leaves it there.
const KEPT: [&str; 10] = [
    "converge",
    "scene.scn",
    "--device",
    "cpu-f32",
    "--spp",
    "1",
    "--time",
    "0.05",
    "--csv",
    "c.csv",
];

/// With these variables set, those that end in `!` not set, and none of the user's own that say where the cache is.
fn with(folder: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Run {
    let mut command = command(folder, arguments);
    for name in ["VKPT_CACHE", "XDG_CACHE_HOME"] {
        command.env_remove(name);
    }
    for (name, value) in variables {
        match name.strip_suffix('!') {
            Some(name) => command.env_remove(name),
            None => command.env(name, value),
        };
    }
    finish(&mut command)
}

/// A cache that cannot be made is no reason to fail, nor to leave files in other places.
#[test]
fn a_cache_that_cannot_be_is_gone_without() {
    let folder = folder(SCENE);
    let file = folder.path().join("scene.scn");
    let file = file.to_str().expect("a name");
    for variables in [
        &[("HOME", "/proc")][..],
        &[("HOME", "relative")],
        &[("HOME", file)],
        &[("XDG_CACHE_HOME", file), ("HOME", "/proc")],
        &[("XDG_CACHE_HOME", "/proc")],
        &[("XDG_CACHE_HOME", "relative"), ("HOME", "/proc")],
        &[("VKPT_CACHE", file)],
        &[("VKPT_CACHE", "/proc")],
        &[("VKPT_CACHE", "")],
    ] {
        let ran = with(folder.path(), &KEPT, variables);
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{variables:?}");
        assert_eq!(
            names(folder.path()),
            ["c.csv", "scene.scn"],
            "{variables:?}"
        );
    }
}

/// Nothing on either stream depends on terminal or language.
#[test]
fn terminal_and_language_change_nothing() {
    let folder = folder(SCENE);
    let rows: [&[(&str, &str)]; 5] = [
        &[("TERM", "dumb")],
        &[("TERM!", ""), ("NO_COLOR!", "")],
        &[("LC_ALL", "C"), ("LANG!", "")],
        &[("LC_ALL", "de_DE.UTF-8")],
        &[("HOME!", ""), ("PATH!", ""), ("TMPDIR", "/nowhere")],
    ];
    for arguments in [&["explain", "scene.scn"][..], &["--help"], &["none.scn"]] {
        let usual = with(folder.path(), arguments, &[]);
        for variables in rows {
            let ran = with(folder.path(), arguments, variables);
            assert_eq!(ran.code, usual.code, "{variables:?}");
            assert_eq!(
                (&ran.out, &ran.err),
                (&usual.out, &usual.err),
                "{variables:?}"
            );
        }
    }
    let null = [
        "scene.scn",
        "--device",
        "cpu-f32",
        "-o",
        "/dev/null",
        "--format",
        "exr",
        "--quiet",
    ];
    let ran = with(folder.path(), &null, &[("TMPDIR", "/nowhere")]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
}

/// A closed stream reads as empty and discards all writes, as Rust makes it: /dev/null.
#[test]
fn closed_streams_are_as_good_as_empty() {
    let folder = folder(SCENE);
    let render = "$VKPT scene.scn --device cpu-f32 --spp 2 -o a.exr";
    let stdin = "$VKPT - --device cpu-f32 --spp 2 -o a.exr";
    for (line, code) in [
        (format!("{render} <&-"), 0),
        (format!("{render} >&-"), 0),
        (format!("{render} 2>&-"), 0),
        (format!("{render} <&- >&- 2>&-"), 0),
        (format!("{render} --json - >&-"), 0),
        (format!("{render} --json /dev/stdout >&-"), 0),
        (format!("{render} --json /dev/stderr 2>&-"), 0),
        (format!("{stdin} <&-"), 3),
        ("$VKPT --help >&-".to_owned(), 0),
        ("$VKPT none.scn 2>&-".to_owned(), 3),
        ("$VKPT --nonsense 2>&-".to_owned(), 2),
    ] {
        let ran = shell(folder.path(), &line);
        assert_eq!(ran.code, Some(code), "{line}: {}", ran.err);
        assert!(!ran.err.contains("panicked"), "{line}: {}", ran.err);
    }
}

/// Blanks, and bytes that are no UTF-8, in every name that a person chooses.
#[test]
fn names_of_any_bytes_are_read_and_written() {
    let folder = folder("");
    let name = |bytes: &[u8]| folder.path().join(OsStr::from_bytes(bytes));
    fs::create_dir(name(b"a \xe9")).expect("a folder");
    fs::write(name(b"a \xe9/s \xff.scn"), MESHED).expect("a scene");
    fs::write(name(b"a \xe9/m.ply"), MESH).expect("a mesh");
    let long = [&[b'n'; 190][..], b"\xff.exr"].concat();
    let rows: [(&[&[u8]], &[u8]); 6] = [
        (
            &[b"a \xe9/s \xff.scn", b"--device", b"cpu-f32"],
            b"s \xff.exr",
        ),
        (
            &[
                b"a \xe9/s \xff.scn",
                b"--device",
                b"cpu-f32",
                b"--aov",
                b"stderr",
                b"-o",
                &long,
            ],
            &long,
        ),
        (
            &[
                b"compare",
                b"s \xff.png",
                b"s \xff.exr",
                b"--heatmap",
                b"h \xff.png",
            ],
            b"h \xff.png",
        ),
        (
            &[b"explain", b"a \xe9/s \xff.scn", b"--spirv", b"k \xff.spv"],
            b"k \xff.spv",
        ),
        (
            &[b"export", b"a \xe9/s \xff.scn", b"--to", b"mitsuba"],
            b"s \xff.xml",
        ),
        (
            &[
                b"converge",
                b"a \xe9/s \xff.scn",
                b"--device",
                b"cpu-f32",
                b"--spp",
                b"1",
                b"--reference",
                b"s \xff.exr",
                b"--html",
                b"c \xff.html",
            ],
            b"c \xff.html",
        ),
    ];
    for (words, written) in rows {
        let mut command = command(folder.path(), &[]);
        command.args(words.iter().map(|word| OsStr::from_bytes(word)));
        let output = command.output().expect("the program runs");
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{message}");
        assert!(name(written).is_file(), "{message}");
    }
    let mut over = command(folder.path(), &[]);
    over.arg(name(b"a \xe9/s \xff.scn"))
        .arg("--json")
        .arg(name(b"a \xe9/m.ply"));
    assert_eq!(finish(&mut over).code, Some(2));
}
