//! `vkpt compare A B`: its output and its exit code.

use std::path::Path;

use insta::assert_snapshot;
use vkpt::film::Film;
use vkpt::image::file::write_whole;
use vkpt::image::{Format, Frame, Labels, encode};
use vkpt::reference::sampler::random::sampler_block;
use vkpt::reference::sampler::unit_float;

use super::program::{Run, names, run, shown};

const SIZE: [u32; 2] = [64, 50];

/// The standard error of every pixel of [`noisy`].
const ERROR: f32 = 0.05;

fn write(folder: &Path, name: &str, film: &Film) {
    let path = folder.join(name);
    let frame = Frame::whole(film);
    let labels = Labels {
        exposure: 0.0,
        software: "test",
        notes: &[],
    };
    let format = Format::of(&path).expect("a known ending");
    write_whole(&path, |out| encode(&frame, format, &labels, out)).expect("a picture");
}

fn film(of: impl Fn(u32, u32) -> [f32; 3]) -> Film {
    let [width, height] = SIZE;
    let rgb = (0..width * height).map(|i| of(i % width, i / width));
    Film {
        width,
        height,
        rgb: rgb.collect(),
    }
}

/// An even slope from .4 to .6 and noise of standard deviation [`ERROR`], normal by the sum of twelve
/// uniform numbers.
fn noisy(seed: u32, scale: f32) -> Film {
    film(|x, y| {
        let slope = 0.4 + 0.2 * x as f32 / SIZE[0] as f32;
        [0, 1, 2].map(|c| {
            let blocks = (0..3).flat_map(|b| sampler_block(y * SIZE[0] + x, c, b, seed));
            let normal: f32 = blocks.map(unit_float::<f32>).sum::<f32>() - 6.0;
            scale * (slope + ERROR * normal)
        })
    })
}

/// `a.exr` and `b.exr`, independent, with their standard errors.
fn folder(a: &Film, b: &Film) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let errors = film(|_, _| [ERROR; 3]);
    for (name, film) in [("a", a), ("b", b)] {
        write(folder.path(), &format!("{name}.exr"), film);
        write(folder.path(), &format!("{name}-stderr.exr"), &errors);
    }
    folder
}

fn compare(folder: &Path, arguments: &[&str]) -> Run {
    run(folder, &[&["compare"], arguments].concat())
}

/// Expects the code and no output; the command and its message.
fn refused(folder: &Path, code: i32, line: &str) -> String {
    let arguments: Vec<&str> = std::iter::once("compare").chain(line.split(' ')).collect();
    let run = run(folder, &arguments);
    assert_eq!(run.code, Some(code), "{line}: {}", run.err);
    assert_eq!(run.out, "", "{line}");
    shown(&arguments, &run.err)
}

#[test]
fn pictures_that_agree() {
    let folder = folder(&noisy(1, 1.0), &noisy(2, 1.0));
    let run = compare(
        folder.path(),
        &["a.exr", "b.exr", "--z-test", "--max-relmse", "0.1"],
    );
    assert_eq!(run.code, Some(0), "{}{}", run.out, run.err);
    assert_snapshot!(run.out);
    let (a, b) = (noisy(1, 1.0), noisy(2, 1.0));
    let values = a.rgb.as_flattened().iter().zip(b.rgb.as_flattened());
    let squares: Vec<f64> = values.map(|(x, r)| f64::from(x - r).powi(2)).collect();
    let mse = squares.iter().sum::<f64>() / squares.len() as f64;
    assert!(
        run.out.contains(&format!("MSE     {mse:.4e} ")),
        "{mse}{}",
        run.out
    );
}

/// ×1.01 is .2 standard errors of a pixel, but 3.5 to 5 of a block's mean.
#[test]
fn one_percent_is_seen_by_the_blocks() {
    let folder = folder(&noisy(1, 1.02), &noisy(2, 1.0));
    let run = compare(folder.path(), &["a.exr", "b.exr", "--z-test"]);
    assert_eq!(run.code, Some(1), "{}{}", run.out, run.err);
    assert_snapshot!("blocks_that_differ", run.out + &run.err);
    // Without the flag it is reported and does not count.
    let run = compare(folder.path(), &["a.exr", "b.exr"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    assert!(run.out.contains("the z-test fails"), "{}", run.out);
}

#[test]
fn an_error_above_the_bound_fails() {
    let folder = folder(&noisy(1, 1.0), &noisy(2, 1.0));
    let run = compare(folder.path(), &["a.exr", "b.exr", "--max-relmse", "1e-3"]);
    assert_eq!(run.code, Some(1));
    assert_snapshot!(run.err);
}

#[test]
fn two_pictures_against_a_third() {
    let folder = folder(&noisy(1, 1.0), &noisy(2, 1.5));
    write(
        folder.path(),
        "r.exr",
        &film(|x, _| [0.4 + 0.2 * x as f32 / SIZE[0] as f32; 3]),
    );
    write(folder.path(), "none.exr", &film(|_, _| [0.0; 3]));
    let by = ["a.exr", "b.exr", "--reference", "r.exr"];
    let errors = ["a-stderr.exr", "b-stderr.exr", "none.exr"];
    let given = errors.iter().flat_map(|file| ["--stderr", file]);
    let arguments: Vec<&str> = by.into_iter().chain(given).collect();
    let run = compare(
        folder.path(),
        &[&arguments[..], &["--heatmap", "map.png"]].concat(),
    );
    assert_eq!(run.code, Some(0), "{}{}", run.out, run.err);
    assert_snapshot!(run.out);
    let map = vkpt::image::read(&folder.path().join("map.png")).expect("a map");
    assert_eq!([map.film.width, map.film.height], [2 * SIZE[0], SIZE[1]]);
    // b is off by half of itself everywhere: its half is brighter.
    let mean = |from: usize| {
        let rows = map.film.rgb.chunks(2 * SIZE[0] as usize);
        rows.flat_map(|row| row[from..from + SIZE[0] as usize].to_vec())
            .map(|p| p[0])
            .sum::<f32>()
    };
    assert!(mean(SIZE[0] as usize) > mean(0));
}

#[test]
fn other_formats_compare_within_their_steps() {
    let folder = folder(&noisy(1, 1.0), &noisy(1, 1.0));
    write(folder.path(), "a.png", &noisy(1, 1.0));
    write(folder.path(), "a.hdr", &noisy(1, 1.0));
    for other in ["a.png", "a.hdr"] {
        let run = compare(folder.path(), &[other, "b.exr", "--max-relmse", "1e-4"]);
        assert_eq!(run.code, Some(0), "{}{}", run.out, run.err);
    }
}

#[test]
fn pictures_that_cannot_be_compared() {
    let folder = folder(&noisy(1, 1.0), &noisy(2, 1.0));
    let path = folder.path();
    let small = Film {
        width: 2,
        height: 1,
        rgb: vec![[0.5; 3]; 2],
    };
    write(path, "small.exr", &small);
    write(path, "alone.exr", &noisy(3, 1.0));
    std::fs::write(path.join("text.exr"), "not a picture").expect("a file");
    let mut broken = noisy(1, 1.0);
    broken.rgb[70][1] = f32::NAN;
    write(path, "nan.exr", &broken);
    let cases = [
        (3, "a.exr small.exr"),
        (3, "a.exr text.exr"),
        (3, "nan.exr b.exr"),
        (3, "none.exr b.exr"),
        (2, "a.exr b.exr --stderr a-stderr.exr"),
        (2, "a.exr"),
        (5, "a.exr b.exr --heatmap no/map.png"),
        (2, "a.exr b.exr --heatmap map.exr"),
    ];
    let messages = cases.map(|(code, line)| refused(path, code, line));
    // This one compares, and then lacks standard errors.
    let untested = ["compare", "a.exr", "alone.exr", "--z-test"];
    let run = run(path, &untested);
    assert_eq!(run.code, Some(2), "{}{}", run.out, run.err);
    assert_snapshot!(messages.concat() + &shown(&untested, &run.err));
    assert!(!names(path).iter().any(|name| name.contains("map")));
}

/// Each comparison has flags that say nothing of the other.
#[test]
fn a_flag_that_would_not_be_looked_at_is_refused() {
    let folder = folder(&noisy(1, 1.0), &noisy(2, 1.0));
    let lines = [
        "a.exr b.exr --spp 3",
        // The default's own value is as misplaced as any other.
        "a.exr b.exr --seed 0",
        "a.exr b.exr --size 4x3",
        "a.exr b.exr --quiet --strict",
        "a.exr b.exr --fresnel exact",
        "--paired scene.scn --heatmap map.png",
        "--paired scene.scn --exposure 0",
        "--paired scene.scn --z-test",
    ];
    let messages = lines.map(|line| refused(folder.path(), 2, line));
    assert_snapshot!(messages.concat());
}
