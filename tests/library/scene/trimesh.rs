//! Meshes that another program wrote, by `tests/data/scene/trimesh/make.py`.

use std::path::Path;

use glam::DVec3;
use vkpt::render::Target;
use vkpt::scene::{MeshFile, read_mesh};
use vkpt::settings::Settings;

use crate::common::render::{difference, film};

const FOLDER: &str = "tests/data/scene/trimesh";

/// The endings of the formats that are compared with PLY.
const OTHERS: [&str; 3] = ["obj", "glb", "gltf"];

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

/// The greatest distance between corners that ought to be one; a triangle may begin with any of its corners.
fn apart(a: &[[DVec3; 3]], b: &[[DVec3; 3]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let off = |a: &[DVec3; 3], b: &[DVec3; 3], turn: usize| {
        let corner = |i: usize| a[i].distance(b[(i + turn) % 3]);
        corner(0).max(corner(1)).max(corner(2))
    };
    let nearest = |a, b| {
        (0..3)
            .map(|turn| off(a, b, turn))
            .fold(f64::INFINITY, f64::min)
    };
    a.iter()
        .zip(b)
        .map(|(a, b)| nearest(a, b))
        .fold(0.0, f64::max)
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
    for name in ["smooth.obj", "smooth.glb"] {
        let (corners, normals) = corners(&read(name));
        assert_eq!(corners, corners_of_ply, "{name}");
        // The files have them in single precision or better.
        let off = apart(&normals.expect("normals"), &normals_of_ply);
        assert!(off < 4.0 * f64::from(f32::EPSILON), "{name}: {off}");
    }
}

/// Three instances under nested transforms, of which one stretches and one mirrors.
#[test]
fn transforms_are_applied() {
    let (truth, _) = corners(&read("family.ply"));
    assert_eq!(truth.len(), 60);
    // OBJ contains trimesh's results, GLB the transforms: in single precision, coordinates below 8.
    for (name, limit) in [
        ("family.obj", 1e-12),
        ("family.glb", 16.0 * f64::from(f32::EPSILON)),
    ] {
        let (corners, normals) = corners(&read(name));
        assert_eq!(normals, None);
        let off = apart(&corners, &truth);
        assert!(off < limit, "{name}: {off}");
    }
    // The comparison sees a triangle that is wound the other way.
    let mut flipped = truth.clone();
    flipped[59].swap(0, 1);
    assert!(apart(&flipped, &truth) > 0.1);
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
