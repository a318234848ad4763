//! `--aov stderr` by each sampler, from the file to its readers: how many degrees of freedom the errors have, and that
//! no message asks for another sampler.

use std::fmt::Write;
use std::path::Path;

use insta::assert_snapshot;

use super::converge::LIT;
use super::program::{folder, run, shown, words};
use super::rendering::read_exr;

/// Runs to a good end, without a warning.
fn silent(folder: &Path, line: &str) {
    let run = words(folder, line);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{line}");
}

const RENDER: &str = "scene.scn --device cpu-f32 --spp 32 --quiet --aov stderr";

#[test]
fn files_say_how_many_degrees_of_freedom_they_have() {
    let folder = folder(LIT);
    let (spread, groups) = (
        "the spread of independent samples",
        "the difference of two independent groups of samples",
    );
    for (flags, from, freedom) in [
        ("--sampler random", spread, "31"),
        ("--sampler sobol", groups, "1"),
        // Quarters are kept in place of moments.
        ("--sampler random --denoise=nlm", groups, "1"),
    ] {
        silent(folder.path(), &format!("{RENDER} {flags} -o a.exr"));
        let file = read_exr(&folder.path().join("a-stderr.exr"));
        let notes = format!(
            "aov: stderr: standard error of the mean, per pixel and channel, from {from}\ndegrees of freedom: {freedom}\n\
            digest of the picture: "
        );
        assert!(file.comments.starts_with(&notes), "{}", file.comments);
    }
}

/// Pictures of the default sampler agree with those of other seeds and of the other sampler, and a light a fifth brighter is
/// noticed.
#[test]
fn pictures_of_any_sampler_are_compared_by_their_errors() {
    let folder = folder(LIT);
    let bright = LIT.replace("light 9 8 7", "light 10.8 9.6 8.4");
    assert_ne!(bright, LIT);
    std::fs::write(folder.path().join("bright.scn"), bright).expect("a scene");
    silent(folder.path(), &format!("{RENDER} -o a.exr"));
    silent(folder.path(), &format!("{RENDER} --seed 5 -o b.exr"));
    silent(
        folder.path(),
        &format!("{RENDER} --seed 6 --sampler random -o c.exr"),
    );
    silent(
        folder.path(),
        &format!("{} --seed 7 -o d.exr", RENDER.replace("scene", "bright")),
    );
    for other in ["b", "c"] {
        silent(
            folder.path(),
            &format!("compare a.exr {other}.exr --z-test"),
        );
    }
    assert_eq!(
        words(folder.path(), "compare a.exr d.exr --z-test").code,
        Some(1)
    );
    silent(
        folder.path(),
        "converge scene.scn --device cpu-f32 --spp 2 --time 9 --quiet --reference a.exr",
    );
}

/// Errors left by another rendering are noticed, in whichever setting it differs.
#[test]
fn errors_of_another_picture_are_refused() {
    let folder = folder(LIT);
    let path = |name: &str| folder.path().join(name);
    std::fs::copy(path("scene.scn"), path("other.scn")).expect("a scene");
    let others = [
        ("scene.scn", "--spp 16"),
        ("scene.scn", "--seed 5"),
        ("scene.scn", "--connect light"),
        ("scene.scn", "--max-depth 3"),
        ("scene.scn", "--integrator light"),
        ("scene.scn", "--crop 0,0,12,7"),
        ("scene.scn", "--size 6x4"),
        ("scene.scn", "--device cpu-f64"),
        ("other.scn", ""),
    ];
    let render = |scene: &str, more: &str, name: &str| {
        // Its own flag replaces that of all.
        let flags = RENDER.split(' ').skip(1).collect::<Vec<_>>().join(" ");
        let flags = match more.split_once(' ') {
            Some(("--spp", _)) => flags.replace("--spp 32 ", ""),
            Some(("--device", _)) => flags.replace("--device cpu-f32 ", ""),
            _ => flags,
        };
        let line = format!("{scene} {flags} {more} -o {name}");
        let ran = run(folder.path(), &line.split_whitespace().collect::<Vec<_>>());
        assert_eq!(ran.code, Some(0), "{line}: {}", ran.err);
    };
    render("scene.scn", "", "a.exr");
    render("scene.scn", "", "b.exr");
    silent(folder.path(), "compare a.exr b.exr --z-test");
    let converge = "converge scene.scn --device cpu-f32 --spp 2 --time 9 --quiet --reference b.exr";
    silent(folder.path(), converge);
    let mut messages = String::new();
    for (scene, more) in others {
        render(scene, more, "c.exr");
        std::fs::rename(path("c-stderr.exr"), path("b-stderr.exr")).expect("renamed");
        let _ = writeln!(messages, "b-stderr.exr: {scene} {more}");
        for line in [
            "compare a.exr b.exr",
            "compare a.exr b.exr --stderr a-stderr.exr --stderr b-stderr.exr",
            converge,
        ] {
            let ran = words(folder.path(), line);
            assert_eq!(ran.code, Some(3), "{more}: {}", ran.err);
            messages += &shown(&line.split(' ').collect::<Vec<_>>(), &ran.err);
        }
    }
    let right = "compare a.exr b.exr --stderr a-stderr.exr --stderr a-stderr.exr";
    silent(folder.path(), right);
    // The same command, and another line in the scene.
    let bright = LIT.replace("light 9 8 7", "light 9 8 7.0001");
    std::fs::write(path("scene.scn"), bright).expect("a scene");
    silent(
        folder.path(),
        "scene.scn --device cpu-f32 --spp 32 --quiet -o a.exr",
    );
    std::fs::remove_file(path("b-stderr.exr")).expect("removed");
    let ran = words(folder.path(), "compare a.exr b.exr");
    messages += "\na-stderr.exr: another scene of the same name\n";
    messages += &shown(&["compare", "a.exr", "b.exr"], &ran.err);
    assert_eq!(ran.code, Some(3), "{messages}");
    assert_snapshot!(messages);
}

/// A PNG has no record of its rendering: the user gets a warning.
#[test]
fn errors_beside_a_picture_without_notes_are_used_with_a_warning() {
    let folder = folder(LIT);
    silent(folder.path(), &format!("{RENDER} -o a.png -o a.exr"));
    let ran = words(folder.path(), "compare a.png a.exr");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let expected = "warning: a.png does not record how it was made: cannot check whether a-stderr.exr belongs to it\n";
    assert_eq!(ran.err, expected);
    assert!(ran.out.contains("z-test"), "{}", ran.out);
}
