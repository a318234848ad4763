//! Whole renderings on the reference renderer: their files, the contents of these, and their exit codes.

use std::fs;
use std::path::Path;

use exr::prelude::{ReadChannels, ReadLayers, Text, Vec2};
use serde_json::Value;

use super::program::{SCENE, folder, names, run};

/// A picture's corner in the full picture, its size, and its pixels, row by row.
#[derive(Debug, PartialEq)]
pub struct Picture {
    pub origin: [i32; 2],
    pub size: [usize; 2],
    pub full: [usize; 2],
    pub comments: String,
    pub rgb: Vec<[f32; 3]>,
}

pub fn read_exr(path: &Path) -> Picture {
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| (size.width(), vec![[0f32; 3]; size.area()]),
            |(width, pixels), Vec2(x, y), (r, g, b): (f32, f32, f32)| {
                pixels[y * *width + x] = [r, g, b]
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_file(path)
        .expect("an EXR");
    let layer = image.layer_data;
    let full = image.attributes.display_window.size;
    Picture {
        origin: [
            layer.attributes.layer_position.x(),
            layer.attributes.layer_position.y(),
        ],
        size: [layer.size.width(), layer.size.height()],
        full: [full.width(), full.height()],
        comments: layer
            .attributes
            .comments
            .as_ref()
            .map_or(String::new(), Text::to_string),
        rgb: layer.channel_data.pixels.1,
    }
}

/// Renders `scene.scn` with the arguments and expects success.
fn rendered(folder: &Path, arguments: &[&str]) -> String {
    let all: Vec<&str> = ["scene.scn", "--device", "cpu-f32"]
        .iter()
        .chain(arguments)
        .copied()
        .collect();
    let run = run(folder, &all);
    assert_eq!(run.code, Some(0), "{arguments:?}: {}", run.err);
    assert_eq!(run.err, "", "{arguments:?}");
    run.out
}

#[test]
fn the_default_is_two_pictures_named_like_the_scene() {
    let folder = folder(SCENE);
    let out = rendered(folder.path(), &["--spp", "2"]);
    assert_eq!(
        names(folder.path()),
        ["scene.exr", "scene.png", "scene.scn"]
    );
    assert!(
        out.starts_with("scene.scn: 8×6, 2 samples per pixel, seed 0\n"),
        "{out}"
    );
    assert!(
        out.contains("\n  wrote   scene.png, scene.exr\n2 spp · "),
        "{out}"
    );

    // The emitter's radiance is 1 where it fills a pixel, and there is nothing around it.
    let picture = read_exr(&folder.path().join("scene.exr"));
    assert_eq!(
        (picture.size, picture.full, picture.origin),
        ([8, 6], [8, 6], [0, 0])
    );
    assert_eq!(
        (picture.rgb[3 * 8 + 4], picture.rgb[0]),
        ([1.0; 3], [0.0; 3])
    );
    assert!(
        picture.comments.contains("scene: scene.scn\nsize: 8x6\n"),
        "{}",
        picture.comments
    );
    assert!(
        picture.comments.contains("spp: 2\nseed: 0\n"),
        "{}",
        picture.comments
    );
}

#[test]
fn an_hdr_has_the_crop_alone() {
    let folder = folder(LIT);
    let outputs = ["-o", "a.hdr", "-o", "a.exr", "--crop", "1,1,6,5"];
    rendered(folder.path(), &outputs);
    let picture = |name| vkpt::image::read(&folder.path().join(name)).expect("a picture");
    let (hdr, exr) = (picture("a.hdr"), picture("a.exr"));
    assert_eq!((hdr.origin, hdr.full), ([0, 0], [5, 4]));
    assert_eq!((exr.origin, exr.full), ([1, 1], [8, 6]));
    for (rounded, exact) in hdr.film.rgb.iter().zip(&exr.film.rgb) {
        let largest = exact.iter().copied().fold(0.0, f32::max);
        for (r, e) in rounded.iter().zip(exact) {
            assert!((r - e).abs() <= largest / 256.0, "{rounded:?} {exact:?}");
        }
    }
}

#[test]
fn the_same_command_leaves_the_same_bytes() {
    let arguments = ["--spp", "3", "--seed", "7", "--crop", "1,1,6,5"];
    let bytes = || {
        let folder = folder(LIT);
        rendered(folder.path(), &arguments);
        ["scene.png", "scene.exr"]
            .map(|name| fs::read(folder.path().join(name)).expect("a picture"))
    };
    assert_eq!(bytes(), bytes());
}

#[test]
fn seeds_differ() {
    let pixels = |seed| {
        let folder = folder(LIT);
        rendered(
            folder.path(),
            &["-o", "a.exr", "--spp", "1", "--seed", seed],
        );
        read_exr(&folder.path().join("a.exr")).rgb
    };
    assert_ne!(pixels("1"), pixels("2"));
}

#[test]
fn a_crop_is_a_piece_of_the_picture() {
    let folder = folder(LIT);
    rendered(folder.path(), &["-o", "full.exr", "--spp", "2"]);
    rendered(
        folder.path(),
        &["-o", "crop.exr", "--spp", "2", "--crop", "2,1,7,4"],
    );
    let [full, crop] = ["full.exr", "crop.exr"].map(|name| read_exr(&folder.path().join(name)));
    assert_eq!(
        (crop.origin, crop.size, crop.full),
        ([2, 1], [5, 3], [8, 6])
    );
    let piece: Vec<_> = (1..4)
        .flat_map(|y| full.rgb[8 * y + 2..8 * y + 7].to_vec())
        .collect();
    assert_eq!(crop.rgb, piece);
}

#[test]
fn quiet_says_nothing_and_json_says_all() {
    let folder = folder(LIT);
    let out = rendered(
        folder.path(),
        &[
            "-o", "a.png", "--quiet", "--json", "a.json", "--size", "5x4", "--spp", "3", "--model",
            "handout",
        ],
    );
    assert_eq!(out, "");
    assert_eq!(names(folder.path()), ["a.json", "a.png", "scene.scn"]);
    let text = fs::read_to_string(folder.path().join("a.json")).expect("a report");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["samples"], 5 * 4 * 3);
    assert!(json["rays"].as_u64() >= json["samples"].as_u64(), "{text}");
    assert_eq!(
        json["dropped"],
        serde_json::json!({ "nan": 0, "infinite": 0, "loop": 0 })
    );
    assert_eq!(json["settings"]["roulette"], "0.8");
    assert_eq!(json["files"], serde_json::json!(["a.png"]));
    for stage in ["read", "prepare", "compose", "compile", "render", "write"] {
        assert!(
            json["seconds"][stage].as_f64().is_some_and(|s| s >= 0.0),
            "{stage}: {text}"
        );
    }
}

/// A lamp so small that paths find it once in a thousand samples.
const LOTTERY: &str = "screen 12 9\ncamera 0 -6 3 .35 x 65\nlight 900 800 700\nsphere 0 0 4 .05\n\
     brdf .6 .5 .4 0 0 0 1\nbox -5 -5 -.1 10 10 .1\n";

/// The last line and the JSON report the same pixels, and the JSON the sample, whose path `--trace` prints.
#[test]
fn the_largest_sample_is_printed_with_its_pixel() {
    let folder = folder(LOTTERY);
    let out = rendered(
        folder.path(),
        &[
            "-o",
            "a.png",
            "--integrator",
            "path",
            "--connect",
            "bsdf",
            "--crop",
            "3,2,11,9",
            "--spp",
            "64",
            "--json",
            "a.json",
        ],
    );
    let text = fs::read_to_string(folder.path().join("a.json")).expect("a report");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let (largest, last) = (&json["largest"], &json["error"][6]);
    let [x, y] = [0, 1].map(|i| largest["pixel"][i].as_u64().expect("a pixel"));
    assert!((3..11).contains(&x) && (2..9).contains(&y), "{text}");
    assert!(largest["weight"].as_f64() > Some(100.0), "{text}");
    assert_eq!(last["spp"], 64);
    assert_eq!((&last["low"], &last["high"]), (&Value::Null, &Value::Null));
    let [u, v] = [0, 1].map(|i| last["worst_pixel"][i].as_u64().expect("a pixel"));
    let message = match last["half_in_pixels"].as_u64().expect("a number") {
        1 => format!("? (half of it in pixel {u},{v})\n"),
        n => format!("? (half of it in {n} pixels, the worst {u},{v})\n"),
    };
    assert!(out.ends_with(&message), "{out}{message}");

    let address = format!("{x},{y},{}", largest["sample"]);
    let path = rendered(folder.path(), &["--connect", "bsdf", "--trace", &address]);
    let radiance = path
        .lines()
        .rfind(|l| l.trim_start().starts_with("radiance"));
    let channels = radiance
        .expect("a radiance")
        .split_whitespace()
        .skip(1)
        .take(3);
    let brightest = channels
        .map(|x| x.parse::<f64>().expect("a number"))
        .fold(0.0, f64::max);
    let printed = largest["radiance"].as_f64().expect("a number");
    assert!(
        (brightest / printed - 1.0).abs() < 1e-6,
        "{printed}\n{path}"
    );
}

#[test]
fn a_flag_beats_a_word_and_a_word_beats_the_preset() {
    let fresnel = |arguments: &[&str]| {
        let folder = folder(&format!("{GLASS}fresnel exact\n{BALL}"));
        rendered(
            folder.path(),
            &[&["-o", "a.exr", "--spp", "4"], arguments].concat(),
        );
        read_exr(&folder.path().join("a.exr")).rgb
    };
    let word = fresnel(&[]);
    assert_eq!(fresnel(&["--fresnel", "exact"]), word);
    assert_ne!(fresnel(&["--fresnel", "schlick"]), word);
    let preset = fresnel(&["--model", "handout"]);
    assert_eq!(
        fresnel(&["--model", "handout", "--fresnel", "exact"]),
        preset
    );
    assert_ne!(
        fresnel(&["--model", "handout", "--fresnel", "schlick"]),
        preset
    );
}

#[test]
fn standard_errors_stand_beside_each_picture() {
    let folder = folder(LIT);
    let common = ["--spp", "8", "--crop", "2,1,7,4", "--sampler", "random"];
    rendered(folder.path(), &[&["-o", "b.exr"][..], &common].concat());
    let with_errors = [
        "-o", "a.png", "-o", "a.exr", "-o", "c.exr", "--aov", "stderr", "--json", "a.json",
    ];
    let out = rendered(folder.path(), &[&with_errors[..], &common].concat());
    let files = ["a.png", "a.exr", "c.exr", "a-stderr.exr", "c-stderr.exr"];
    assert!(
        out.contains(&format!("\n  wrote   {}\n8 spp · ", files.join(", "))),
        "{out}"
    );
    let text = fs::read_to_string(folder.path().join("a.json")).expect("a report");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["files"], serde_json::json!(files));

    let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a picture");
    assert!(bytes("a.exr") == bytes("b.exr"), "the picture is another");
    assert!(bytes("a-stderr.exr") == bytes("c-stderr.exr"));
    let [picture, errors] =
        ["a.exr", "a-stderr.exr"].map(|name| read_exr(&folder.path().join(name)));
    assert_eq!(
        (errors.origin, errors.size, errors.full),
        (picture.origin, picture.size, picture.full)
    );
    assert!(errors.rgb.iter().flatten().any(|&e| e > 0.0));
    let mut notes = errors.comments.splitn(4, '\n');
    let mut next = || notes.next().expect("notes");
    let first = next();
    assert!(
        first.starts_with("aov: stderr: standard error of the mean"),
        "{first}"
    );
    assert_eq!(next(), "degrees of freedom: 7");
    let digest = next().strip_prefix("digest of the picture: ");
    assert!(digest.is_some_and(|hex| hex.len() == 32), "{digest:?}");
    assert_eq!(next(), picture.comments);
}

/// A diffuse floor under a small light.
const LIT: &str = "screen 8 6\ncamera 0 0 5 0.3\nlight 9 8 7\nsphere 0 3 1 0.5\n\
    brdf .5 .6 .7 0 0 0 1\nbox -9 -9 -2 18 18 1\n";

const GLASS: &str = "screen 8 6\ncamera 0 0 5 0.3\nbackground 1 2 3\n";
const BALL: &str = "brdf 0 0 0 .1 .1 .1 .3 .9 .5 .2 1.5\nsphere 0 0 0 1\n";

#[test]
fn a_trace_goes_to_stdout_and_leaves_no_file() {
    let folder = folder(LIT);
    let out = rendered(folder.path(), &["--trace", "4,3,5"]);
    assert!(out.contains("vertex") && out.contains("cpu-f32"), "{out}");
    assert_eq!(names(folder.path()), ["scene.scn"]);
}
