//! The help and version of the program.

use std::fs;

use super::program::{SCENE, command, finish, folder, run, without_vulkan, words};

#[test]
fn help_names_every_flag_and_exit_code() {
    let folder = folder("");
    let help = run(folder.path(), &["render", "--help"]);
    assert_eq!((help.code, help.err.as_str()), (Some(0), ""));
    let flags = "-o --format --spp --seed --size --crop --aov --exposure --device --kernel --model --fresnel --distribution \
        --absorption --radiance-scaling --max-depth --lobe --normals --roulette --connect --sampler --json --quiet \
        --strict --trace";
    for word in flags.split_whitespace().chain(["cpu-f64", "cpu-f32"]) {
        assert!(help.out.contains(word), "{word} is missing");
    }
    for code in ["0  ", "1  ", "2  ", "3  ", "4  ", "5  ", "130  "] {
        assert!(
            help.out
                .lines()
                .any(|line| line.trim_start().starts_with(code)),
            "{code} is missing"
        );
    }
    assert!(help.out.lines().all(|line| line.chars().count() <= 100));
    assert_eq!(run(folder.path(), &["render", "-h"]).out, help.out);
}

#[test]
fn the_first_page_of_help_fits_a_screen() {
    let folder = folder("");
    let help = finish(command(folder.path(), &["--help"]).env("COLUMNS", "80"));
    assert_eq!((help.code, help.err.as_str()), (Some(0), ""));
    assert!(help.out.lines().count() <= 40, "{}", help.out);
    assert!(
        help.out.lines().all(|line| line.chars().count() <= 80),
        "{}",
        help.out
    );
    for word in [
        "-o",
        "--spp",
        "--time",
        "--target-error",
        "--device",
        "init",
        "farm",
    ] {
        assert!(help.out.contains(word), "{word} is missing");
    }
    for word in ["--roulette", "[aliases", "--trace"] {
        assert!(!help.out.contains(word), "{word} is there");
    }
}

/// Flags that are not shown there are accepted all the same.
#[test]
fn the_word_render_may_be_left_out() {
    let folder = folder(SCENE);
    let line = "scene.scn --roulette 0.8 --spp 4 --quiet -o";
    assert_eq!(words(folder.path(), &format!("{line} a.exr")).code, Some(0));
    assert_eq!(
        words(folder.path(), &format!("render {line} b.exr")).code,
        Some(0)
    );
    let [a, b] = ["a.exr", "b.exr"].map(|name| fs::read(folder.path().join(name)).expect(name));
    assert!(a == b);
}

#[test]
fn the_version_is_the_packages() {
    let version = run(folder("").path(), &["--version"]);
    assert_eq!(
        version.out,
        concat!("vkpt ", env!("CARGO_PKG_VERSION"), "\n")
    );
}

#[test]
fn devices_list_vulkan_and_the_reference_renderer() {
    if without_vulkan() {
        return;
    }
    let folder = folder("");
    let devices = run(folder.path(), &["devices"]);
    assert_eq!(devices.code, Some(0), "{}", devices.err);
    let first_words: Vec<_> = devices
        .out
        .lines()
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(first_words.starts_with(&["DEVICE", "0"]), "{}", devices.out);
    assert!(
        first_words.ends_with(&["cpu-f32", "cpu-f64"]),
        "{}",
        devices.out
    );
}
