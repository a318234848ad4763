//! `--aov stderr` by each sampler, from the file to those who read it: how many degrees of freedom the errors have, and that
//! nobody is told to use another sampler.

use std::path::Path;

use super::converge::LIT;
use super::program::{Run, folder, run};
use super::rendering::read_exr;

fn words(folder: &Path, line: &str) -> Run {
    run(folder, &line.split(' ').collect::<Vec<_>>())
}

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
            "aov: stderr: standard error of the mean, per pixel and channel, from {from}\ndegrees of freedom: {freedom}\n"
        );
        assert!(file.comments.starts_with(&notes), "{}", file.comments);
    }
}

/// Pictures of the default sampler agree with those of other seeds and of the other sampler, and a light a fifth brighter
/// is found out.
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
