//! `--denoise`: pictures next to the noisy ones, by vkpt's own means and by a stand-in library for Open Image Denoise.

use std::fs;
use std::path::Path;
use std::process::Command;

use insta::assert_snapshot;
use serde_json::Value;
use vkpt::image::{read, read_layer};

use super::program::{folder, shown, words};

pub const SCENE: &str = "screen 40 32
camera 0 0 5 .4
background .5 .5 .5
brdf .5 .25 .125 0 0 0 1
sphere 0 0 0 1
light 9 9 9
sphere 3 3 3 1.5
";

const RENDER: &str =
    "scene.scn --spp 16 --connect bsdf --device cpu-f32 --checkpoint off -o a.exr -o a.png";

fn json(folder: &Path, name: &str) -> Value {
    let text = fs::read_to_string(folder.join(name)).expect("a report");
    serde_json::from_str(&text).expect("JSON")
}

/// A lamp that paths hit by chance, so smooth surfaces have noise. The noisy picture is that of the sampler with four groups
/// with any denoiser; the denoised one is nearer to a good one.
#[test]
fn denoised_pictures_stand_beside_noisy_ones() {
    let folder = folder(SCENE);
    let at = |name: &str| read(&folder.path().join(name)).expect("a picture");
    let run = words(
        folder.path(),
        &format!("{RENDER} --denoise=nlm --json r.json"),
    );
    assert_eq!(run.code, Some(0), "{}", run.err);
    let last = run.out.lines().last().unwrap_or_default();
    assert!(
        last.contains("denoised from half of the samples has a relMSE of at most"),
        "{last}"
    );
    assert!(
        last.contains("not the error of the noisy picture"),
        "{last}"
    );
    let noisy = at("a.exr").film;
    let plain = "scene.scn --spp 16 --connect bsdf --device cpu-f32 --quiet --checkpoint off --sampler sobol-quarters -o b.exr";
    assert_eq!(words(folder.path(), plain).code, Some(0));
    assert!(at("b.exr").film == noisy);
    let good =
        "scene.scn --spp 2048 --seed 1 --device cpu-f32 --quiet --checkpoint off -o good.exr";
    assert_eq!(words(folder.path(), good).code, Some(0));
    let error = |name: &str| {
        let out = words(folder.path(), &format!("compare {name} good.exr"));
        assert_eq!(out.code, Some(0), "{}", out.err);
        let line = out.out.lines().find_map(|line| line.strip_prefix("relMSE"));
        let number = line.and_then(|line| line.split_whitespace().next());
        number
            .and_then(|x| x.parse::<f64>().ok())
            .expect("a relMSE")
    };
    let [noisy, denoised] = ["a.exr", "a-denoised.exr"].map(error);
    assert!(denoised < noisy / 2.0, "{denoised} of {noisy}");
    let record = &json(folder.path(), "r.json")["denoised"];
    assert_eq!(
        record["files"],
        serde_json::json!(["a-denoised.exr", "a-denoised.png"])
    );
    assert_eq!(
        (&record["by"], &record["half_spp"]),
        (&"non-local means".into(), &8.into())
    );
    assert!(
        at("a-denoised.exr")
            .notes
            .contains("denoised: by non-local means\n")
    );
    assert!(!at("a.exr").notes.contains("denoised"));
}

/// The stand-in, built.
fn stand_in(folder: &Path) {
    let source = crate::common::root().join("tests/commands/oidn/oidn.c");
    let ran = Command::new("cc")
        .args(["-shared", "-fPIC", "-Wall", "-Wextra", "-Werror", "-o"])
        .arg(folder.join("libOpenImageDenoise.so.2"))
        .arg(source)
        .output();
    let ran = ran.expect("cc, which links Rust programs");
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
}

/// The library's inputs and output go where they should: its mean of colour, albedo and normal is the one computed here.
#[cfg(target_os = "linux")]
#[test]
fn the_library_is_handed_colour_albedo_and_normal() {
    let folder = folder(SCENE);
    stand_in(folder.path());
    let run = words(
        folder.path(),
        &format!("{RENDER} --denoise --oidn . --json r.json"),
    );
    assert_eq!(run.code, Some(0), "{}", run.err);
    let by = &json(folder.path(), "r.json")["denoised"]["by"];
    assert_eq!(by, "Open Image Denoise 2.3.99");
    // Features are made by samples of another seed, the complement, and are the layers of a picture of 128 samples or more.
    let layers = format!(
        "scene.scn --spp 128 --seed {} --device cpu-f32 --sampler sobol-quarters --quiet --checkpoint off --aov albedo*,normal* -o l.exr",
        !0u32
    );
    assert_eq!(words(folder.path(), &layers).code, Some(0));
    let at = |name: &str| folder.path().join(name);
    let layer = |name| read_layer(&at("l.exr"), name).expect(name).film.rgb;
    let (albedo, normal) = (layer("AlbedoBehind"), layer("NsBehind"));
    let noisy = read(&at("a.exr")).expect("a picture").film.rgb;
    let denoised = read(&at("a-denoised.exr")).expect("a picture").film.rgb;
    for i in 0..noisy.len() {
        let mean = [0, 1, 2].map(|c| (noisy[i][c] + albedo[i][c] + normal[i][c].abs()) / 3.0);
        assert_eq!(denoised[i], mean, "pixel {i}");
    }
}

/// One line, exit code 1, and the noisy picture.
#[cfg(target_os = "linux")]
#[test]
fn a_library_that_does_not_work_leaves_the_noisy_picture() {
    let folder = folder(SCENE);
    fs::write(folder.path().join("text.so"), "not a library").expect("a file");
    let old = "int oidnGetVersion(void); int oidnGetVersion(void) { return 10000; }";
    fs::write(folder.path().join("old.c"), old).expect("a file");
    let cc = Command::new("cc")
        .current_dir(folder.path())
        .args(["-shared", "-fPIC", "-o", "old.so", "old.c"])
        .status();
    assert!(cc.expect("cc").success());
    stand_in(folder.path());
    for (library, fails, message) in [
        (
            "nowhere",
            false,
            "no denoised picture will be written: --oidn nowhere: libOpenImageDenoise.so.2 does not exist",
        ),
        ("text.so", false, "--oidn text.so: "),
        (
            "old.so",
            false,
            "it has no oidnNewDevice: Open Image Denoise 2 or later is needed",
        ),
        (
            ".",
            true,
            "no denoised picture was written: Open Image Denoise: out of patience",
        ),
    ] {
        let mut line = format!("{RENDER} --quiet --denoise --oidn {library}");
        if fails {
            line += " --seed 1";
        }
        let mut command =
            super::program::command(folder.path(), &line.split(' ').collect::<Vec<_>>());
        if fails {
            command.env("STAND_IN_FAILS", "1");
        }
        let out = command.output().expect("a run");
        let err = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(1), "{library}: {err}");
        assert!(err.contains(message), "{library}: {err}");
        assert_eq!(err.trim().lines().count(), 1, "{library}: {err}");
        assert!(
            folder.path().join("a.exr").exists() && !folder.path().join("a-denoised.exr").exists()
        );
        fs::remove_file(folder.path().join("a.exr")).expect("the picture");
    }
}

#[test]
fn renderings_that_cannot_be_denoised_are_refused() {
    let folder = folder(SCENE);
    let lines = [
        "scene.scn --spp 3 --denoise",
        "scene.scn --samples 0..8 --denoise",
        "scene.scn --denoise=blur",
        "scene.scn --denoise -o - --format png",
        "scene.scn --denoise -o a.png -o a-denoised.png",
    ];
    let messages = lines.map(|line| {
        let run = words(folder.path(), line);
        assert_eq!(run.code, Some(2), "{line}: {}", run.err);
        shown(&line.split(' ').collect::<Vec<_>>(), &run.err)
    });
    assert_snapshot!(messages.concat());
}

/// The part contains quarters of the samples: a resumed rendering is denoised as if there had been no pause.
#[test]
fn a_denoised_picture_is_the_same_after_a_pause() {
    let folder = folder(SCENE);
    let denoised = |line: &str| {
        let run = words(
            folder.path(),
            &format!("scene.scn --device cpu-f32 --quiet --denoise=nlm {line}"),
        );
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{line}");
        read(&folder.path().join("a-denoised.exr"))
            .expect("a picture")
            .film
    };
    let whole = denoised("--spp 24 -o a.exr");
    denoised("--spp 10 -o a.exr -o p.vkpt");
    assert!(denoised("--spp 24 -o a.exr -o p.vkpt --resume") == whole);
    let run = words(
        folder.path(),
        "scene.scn --spp 30 --device cpu-f32 --sampler sobol-quarters -o a.exr -o p.vkpt --resume",
    );
    assert_eq!(run.code, Some(3));
    assert!(
        run.err.contains("it was rendered with --denoise: add that"),
        "{}",
        run.err
    );
}
