//! What a large scene is said to take of the host's memory, beside what it took by the kernel's count.

use std::fs;
use std::path::Path;

use serde_json::Value;
use vkpt::prepared::triangles_and_peak;
use vkpt::scene::parse;

use super::program::{folder, run};
use crate::common::icosphere::mesh::{Icosphere, ply};

const SCENE: &str = "screen 8 6\ncamera 0 0 5 .3\nlight 1 1 1\nmesh blob.ply 0 0 0 1\n";

/// Of 300,000 triangles, flat and smooth, "about" means: less than half as much again, more than two thirds.
#[cfg(target_os = "linux")]
#[test]
fn the_peak_is_about_what_is_said_beforehand() {
    for smooth in [false, true] {
        let folder = folder(SCENE);
        let mesh = Icosphere::new(123, 0.1, 0);
        let normals = smooth.then(|| mesh.normals());
        let file = ply::bytes(&mesh, normals.as_deref());
        fs::write(folder.path().join("blob.ply"), file).expect("a mesh");
        let read = parse(SCENE, &folder.path().join("scene.scn"), false).expect("a good scene");
        let (triangles, said) = triangles_and_peak(&read.scene);
        assert_eq!(triangles, 302_580);
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
        let ratio = took as f64 / said as f64;
        assert!(
            (2.0 / 3.0..1.5).contains(&ratio),
            "{took} bytes, said {said}"
        );
        let page = run(folder.path(), &["explain", "scene.scn"]).out;
        assert!(page.contains("at most"), "{page}");
    }
}

#[test]
fn a_small_scene_takes_too_little_to_be_spoken_of() {
    let page = run(Path::new("."), &["explain", "scenes/room.txt"]).out;
    assert!(!page.contains("at most"), "{page}");
}
