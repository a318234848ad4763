//! Meshes that another program wrote: `fixtures/trimesh/make.py` tells how.

use std::path::Path;

use glam::DVec3;
use vkpt::render::Target;
use vkpt::scene::{MeshFile, read_mesh};
use vkpt::settings::Settings;

use crate::common::render::{difference, film};

const FOLDER: &str = "tests/scene/fixtures/trimesh";

/// The endings of the formats that are held against PLY.
const OTHERS: [&str; 1] = ["obj"];

fn read(name: &str) -> MeshFile {
    read_mesh(&Path::new(FOLDER).join(name)).expect(name)
}

/// The corners of the triangles, and their normals, in file order.
fn corners(mesh: &MeshFile) -> (Vec<[DVec3; 3]>, Option<Vec<[DVec3; 3]>>) {
    let of = |all: &Vec<DVec3>| {
        let triangle = |t: &[u32; 3]| t.map(|i| all[i as usize]);
        mesh.triangles.iter().map(triangle).collect::<Vec<_>>()
    };
    (of(&mesh.positions), mesh.normals.as_ref().map(of))
}

/// The greatest distance between corners that ought to be one.
fn apart(a: &[[DVec3; 3]], b: &[[DVec3; 3]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[test]
fn one_solid_is_the_same_in_every_format() {
    let ply = corners(&read("gem.ply"));
    assert_eq!((ply.0.len(), &ply.1), (20, &None));
    for name in OTHERS.map(|ending| format!("gem.{ending}")) {
        assert_eq!(corners(&read(&name)), ply, "{name}");
    }
}

#[test]
fn so_are_its_normals() {
    let (corners_of_ply, normals_of_ply) = corners(&read("smooth.ply"));
    let normals_of_ply = normals_of_ply.expect("normals");
    for name in OTHERS.map(|ending| format!("smooth.{ending}")) {
        let (corners, normals) = corners(&read(&name));
        assert_eq!(corners, corners_of_ply, "{name}");
        // The files have them in single precision or better.
        let off = apart(&normals.expect("normals"), &normals_of_ply);
        assert!(off < 4.0 * f64::from(f32::EPSILON), "{name}: {off}");
    }
}

#[test]
fn one_solid_makes_one_picture() {
    let picture = |name: &str| {
        let text = format!(
            "screen 24 18\ncamera 0 0 3 .4\nbackground 1 .9 .8\nbrdf 0 0 0 .04 .04 .04 .2 .4 .6 .8 1.5\n\
             mesh {FOLDER}/{name} 0 0 0 1 x 20\n"
        );
        film(&text, Settings::default(), 4, 0, &Target::CpuF32)
    };
    let ply = picture("gem.ply");
    for name in OTHERS.map(|ending| format!("gem.{ending}")) {
        assert_eq!(difference(&picture(&name), &ply), None, "{name}");
    }
}
