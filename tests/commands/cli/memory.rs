//! The host memory that a large scene is announced to take, compared with that which it took by the kernel's count.

use std::fs;
use std::path::Path;

use serde_json::Value;
use vkpt::prepared::Footprint;
use vkpt::scene::parse;

use super::program::{folder, run};
use crate::common::icosphere::mesh::{Icosphere, ply};
use crate::common::root;

const SCENE: &str = "screen 8 6\ncamera 0 0 5 .3\nlight 1 1 1\nmesh blob.ply 0 0 0 1\n";

/// Of 300,000 triangles, flat and smooth, "about" means: less than half as much again, more than two thirds.
#[cfg(target_os = "linux")]
#[test]
fn the_peak_is_about_the_announced_size() {
    for smooth in [false, true] {
        let folder = folder(SCENE);
        let mesh = Icosphere::new(123, 0.1, 0);
        let normals = smooth.then(|| mesh.normals());
        let file = ply::bytes(&mesh, normals.as_deref());
        fs::write(folder.path().join("blob.ply"), file).expect("a mesh");
        let read = parse(SCENE, &folder.path().join("scene.scn"), false).expect("a good scene");
        let footprint = Footprint::of(&read.scene);
        let announced = footprint.peak();
        assert_eq!(footprint.triangles, 302_580);
        let render = [
            "scene.scn",
            "--spp",
            "1",
            "--device",
            "cpu-f32",
            "--quiet",
            "--json",
            "-",
        ];
        let report: Value = serde_json::from_str(&run(folder.path(), &render).out).expect("JSON");
        let took = report["memory"]["peak"].as_u64().expect("Linux counts");
        let ratio = took as f64 / announced as f64;
        assert!(
            (2.0 / 3.0..1.5).contains(&ratio),
            "{took} bytes, announced {announced}"
        );
        let page = run(folder.path(), &["explain", "scene.scn"]).out;
        assert!(page.contains("at most"), "{page}");
    }
}

#[test]
fn a_small_scene_takes_too_little_to_be_spoken_of() {
    let page = run(root(), &["explain", "scenes/room.txt"]).out;
    assert!(!page.contains("at most"), "{page}");
}

/// Runs the program with so many KiB of address space.
#[cfg(target_os = "linux")]
fn within(folder: &Path, kib: u32, line: &str) -> (Option<i32>, String) {
    let program = env!("CARGO_BIN_EXE_vkpt");
    let run = std::process::Command::new("sh")
        .current_dir(folder)
        .env_remove("RUST_BACKTRACE")
        // Each thread takes its own address space.
        .env("RAYON_NUM_THREADS", "2")
        .args(["-c", &format!("ulimit -v {kib}; exec {program} {line}")])
        .output()
        .expect("a shell");
    let err = String::from_utf8_lossy(&run.stderr).into_owned();
    (run.status.code(), err)
}

/// 2^28 pixels, of 80 bytes and more each.
#[cfg(target_os = "linux")]
#[test]
fn a_picture_that_cannot_fit_is_refused_before_its_first_sample() {
    let folder = folder(&SCENE.replace("mesh blob.ply 0 0 0 1", "sphere 0 0 0 1"));
    for line in [
        "scene.scn --size 16384x16384 --device cpu-f32 -o a.exr",
        "scene.scn --size 16384x16384 --device cpu-f64 -o a.exr",
        "scene.scn --size 16384x16384 --integrator light -o a.exr",
        "converge scene.scn --size 16384x16384 --device cpu-f32 --spp 1",
    ] {
        let (code, err) = within(folder.path(), 6_000_000, line);
        assert_eq!(code, Some(6), "{line}: {err}");
        assert!(
            err.contains("error: the films of the picture take "),
            "{line}: {err}"
        );
        assert!(
            err.contains("use --size or --crop for a smaller picture"),
            "{line}: {err}"
        );
    }
    let (code, err) = within(
        folder.path(),
        6_000_000,
        "scene.scn --device cpu-f32 --quiet -o a.exr",
    );
    assert_eq!((code, &*err), (Some(0), ""));
}

/// With any amount of memory, it suffices, the scene is refused with its own figure, or the missing memory is reported.
#[cfg(target_os = "linux")]
#[test]
fn a_scene_that_cannot_fit_is_refused_with_its_size() {
    let folder = folder(SCENE);
    let mesh = Icosphere::new(123, 0.1, 0);
    fs::write(folder.path().join("blob.ply"), ply::bytes(&mesh, None)).expect("a mesh");
    let line = "scene.scn --device cpu-f32 --spp 1 --quiet -o a.exr";
    // The program's own memory depends on how it was built and on the machine's libraries. With little more, the mesh
    // cannot be read.
    let starts = |kib: &u32| within(folder.path(), *kib, "--version").0 == Some(0);
    let least = (4_000..100_000).step_by(4_000).find(starts);
    let least = least.expect("100 MB let the program start");
    let close = (least..least + 40_000).step_by(4_000);
    let (mut refused, mut failed, mut sufficed) = (0, 0, 0);
    for kib in close.chain((100_000..900_000).step_by(50_000)) {
        let (code, err) = within(folder.path(), kib, line);
        let is_refused = err.starts_with("error: 302,580 triangles take about ");
        let has_failed = err.contains("memory allocation of ") && err.contains(" bytes failed")
            || err.contains(" bytes of memory, which are not available");
        match code {
            Some(0) => sufficed += 1,
            Some(6) if is_refused => refused += 1,
            Some(6) if has_failed => failed += 1,
            Some(6) if err.starts_with("error: cannot create threads: ") => {}
            _ => panic!("{kib} KiB: {code:?} {err}"),
        }
    }
    assert!(
        refused > 0 && failed > 0 && sufficed > 0,
        "{refused}, {failed}, {sufficed}"
    );
}
