//! `--aov stderr` by each sampler, from the file to its readers: how many degrees of freedom the errors have, and that
//! no message asks for another sampler.

use std::path::Path;

use super::converge::LIT;
use super::program::{folder, run, words};
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
    for (sampler, from, freedom) in [
        ("random", "the spread of independent samples", "31"),
        (
            "sobol",
            "the difference of two independent groups of samples",
            "1",
        ),
    ] {
        silent(
            folder.path(),
            &format!("{RENDER} --sampler {sampler} -o {sampler}.exr"),
        );
        let file = read_exr(&folder.path().join(format!("{sampler}-stderr.exr")));
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
    let rows = [
        ("scene.scn", "--spp 16", "spp is 16 there and 32 here"),
        ("scene.scn", "--seed 5", "seed is 5 there and 0 here"),
        (
            "scene.scn",
            "--connect light",
            "settings is connect=light there and connect=mis here",
        ),
        (
            "scene.scn",
            "--max-depth 3",
            "settings is max-depth=3 there and max-depth=none here",
        ),
        (
            "scene.scn",
            "--integrator light",
            "settings is integrator=light there and the default here",
        ),
        (
            "scene.scn",
            "--crop 0,0,12,7",
            "crop is 0,0,12,7 there and none here",
        ),
        ("scene.scn", "--size 6x4", "size is 6x4 there and 12x8 here"),
        ("scene.scn", "--device cpu-f64", "device is "),
        (
            "other.scn",
            "",
            "scene is other.scn there and scene.scn here",
        ),
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
    for (scene, more, said) in rows {
        render(scene, more, "c.exr");
        std::fs::rename(path("c-stderr.exr"), path("b-stderr.exr")).expect("renamed");
        let said = format!("error: b-stderr.exr does not belong to b.exr: {said}");
        for (line, advice) in [
            ("compare a.exr b.exr", "name the right one with --stderr"),
            (
                "compare a.exr b.exr --stderr a-stderr.exr --stderr b-stderr.exr",
                "--stderr",
            ),
            (converge, "or remove it"),
        ] {
            let ran = words(folder.path(), line);
            assert_eq!(ran.code, Some(3), "{more}: {}", ran.err);
            assert!(
                ran.err.starts_with(&said) && ran.err.contains(advice),
                "{more}: {}",
                ran.err
            );
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
    let said = "error: a-stderr.exr does not belong to a.exr: it was made with a picture of other values, perhaps from another \
        version of the scene; render again with --aov stderr, or name the right one with --stderr\n";
    assert_eq!((ran.code, ran.err.as_str()), (Some(3), said));
}

/// A PNG has no record of its rendering: the user gets a warning.
#[test]
fn errors_beside_a_picture_without_notes_are_used_with_a_warning() {
    let folder = folder(LIT);
    silent(folder.path(), &format!("{RENDER} -o a.png -o a.exr"));
    let ran = words(folder.path(), "compare a.png a.exr");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let said = "warning: a.png does not record how it was made: cannot check whether a-stderr.exr belongs to it\n";
    assert_eq!(ran.err, said);
    assert!(ran.out.contains("z-test"), "{}", ran.out);
}
