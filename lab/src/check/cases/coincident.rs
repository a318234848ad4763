//! Faces that are in one place: lamps flush with ceilings, duplicated lines, posters, glass that touches glass.

use std::f64::consts::PI;

use glam::{DQuat, DVec3};

use super::contact::GLASS;
use super::furnace::CUBE;
use crate::check::case::{Case, Stiffness};
use crate::check::closed::polygon::irradiance;
use vkpt::scene::Mesh;

pub fn cases() -> Vec<Case> {
    vec![
        glass_cubes(),
        flush(
            "flush-lamp",
            "a lamp flush with a ceiling",
            &[LAMP, CEILING],
            lamp_over_floor(),
        ),
        flush(
            "flush-ceiling",
            "a ceiling flush with a lamp, which it covers",
            &[CEILING, LAMP],
            0.0,
        ),
        doubled_lamp(),
        lit(
            "twice",
            "a ball whose line is duplicated",
            "sphere 0 0 0 1\nsphere 0 0 0 1\n",
            None,
        ),
        lit(
            "cylinder-twice",
            "a cylinder whose line is duplicated",
            "cylinder -.1 .2 -1 .1 0 2 2\ncylinder -.1 .2 -1 .1 0 2 2\n",
            None,
        ),
        lit(
            "poster",
            "a square on a box",
            "box -9 -9 -1 18 18 1\n",
            Some(square(DQuat::IDENTITY, 1.0, 0.0)),
        ),
        tilted(),
    ]
}

/// Two cubes of glass that share a face, and one on top of both.
fn glass_cubes() -> Case {
    let mut cubes = cube(DVec3::new(-1.0, 0.0, -0.5));
    append(&mut cubes, cube(DVec3::new(1.0, 0.2, -0.5)));
    append(&mut cubes, cube(DVec3::new(0.1, 0.0, 1.5)));
    let text = format!("screen 16 16\ncamera 0 -6 2 .2 x 70\nbackground 1 1 1\n{GLASS}");
    let stiff = Stiffness::new(
        12.0,
        64.0,
        1.0,
        "barycentric coordinates, and where a ray leaves near an edge; all weights are 1",
    );
    Case::new(
        "coincident/cubes",
        "three cubes of glass that touch, of triangles",
        text,
        stiff,
    )
    .mesh(cubes)
    .mean(1.0, "smooth glass that absorbs nothing is invisible")
}

const LAMP: &str = "light 6 6 6\nbox -1 -1 3 2 2 .1\n";
const CEILING: &str = "brdf 0 0 0 0 0 0 1\nbox -5 -5 3 10 10 .2\n";
const FLOOR: &str = "brdf .7 .7 .7 0 0 0 1\nbox -5 -5 -1 10 10 1\n";

/// Kd/π E of the square lamp, 3 above the floor: by Lambert's formula.
fn lamp_over_floor() -> f64 {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let corners = corners.map(|(x, y)| DVec3::new(x, y, 3.0));
    0.7 / PI * 6.0 * irradiance(&corners, DVec3::Z)
}

/// The floor below, lit only by the lamp; faces of boxes that coincide.
fn flush(name: &str, about: &str, boxes: &[&str], value: f64) -> Case {
    let text = format!("screen 16 16\ncamera 0 0 1 1e-9\n{FLOOR}{}", boxes.concat());
    let stiff = Stiffness::new(2.0, 1.0, 1.0, "flat");
    Case::new(format!("coincident/{name}"), about, text, stiff)
        .spp(64)
        .mean(
            value,
            "Kd/π E by Lambert's formula, or nothing where the ceiling comes first",
        )
}

/// A ray finds one surface, so only one lamp contributes.
fn doubled_lamp() -> Case {
    let mut lamp = square(DQuat::IDENTITY, 1.0, 3.0);
    let twice = lamp.triangles.clone();
    lamp.triangles.extend(twice);
    let text = format!("screen 16 16\ncamera 0 0 1 1e-9\n{FLOOR}light 6 6 6\n");
    let stiff = Stiffness::new(2.0, 1.0, 1.0, "flat");
    Case::new(
        "coincident/doubled-lamp",
        "a lamp whose faces are duplicated in its file",
        text,
        stiff,
    )
    .mesh(lamp)
    .spp(64)
    .mean(lamp_over_floor(), "Kd/π E by Lambert's formula")
}

/// A convex or flat surface under a sky of radiance 1 reflects Kd; it fills the picture.
fn lit(name: &str, about: &str, shapes: &str, mesh: Option<Mesh>) -> Case {
    let text = format!(
        "screen 16 16\ncamera 0 -6 6 .02 x 45\nbackground 1 1 1\nbrdf .5 .5 .5 0 0 0 1\n{shapes}"
    );
    let stiff = Stiffness::new(2.0, 4.0, 1.0, "4 for curved shapes");
    let case = Case::new(format!("coincident/{name}"), about, text, stiff);
    let case = match mesh {
        Some(mesh) => case.mesh(mesh),
        None => case,
    };
    case.mean(0.5, "Kd: a coincident shape casts no shadow")
}

/// A small square on a large one, in a plane that is perpendicular to no axis.
fn tilted() -> Case {
    let turn = DQuat::from_rotation_y(0.17);
    let mut squares = square(turn, 9.0, 0.3);
    append(&mut squares, square(turn, 1.0, 0.3));
    lit("tilted", "a square on a square, turned", "", Some(squares))
}

/// The square from −size to size, turned, then lifted to z.
fn square(turn: DQuat, size: f64, z: f64) -> Mesh {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let place = |(x, y)| turn * DVec3::new(size * x, size * y, 0.0) + DVec3::Z * z;
    mesh(corners.map(place).to_vec(), vec![[0, 1, 2], [0, 2, 3]])
}

/// The cube of side 2 about `centre`.
fn cube(centre: DVec3) -> Mesh {
    let corner = |i: u32| {
        let side = |bit: u32| f64::from(i >> bit & 1) * 2.0 - 1.0;
        centre + DVec3::new(side(0), side(1), side(2))
    };
    mesh((0..8).map(corner).collect(), CUBE.to_vec())
}

fn mesh(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Mesh {
    Mesh {
        path: "made here".into(),
        files: Vec::new(),
        positions,
        normals: None,
        triangles,
        translate: DVec3::ZERO,
        scale: 1.0,
        rotate: DQuat::IDENTITY,
    }
}

/// Another mesh, in the same material.
fn append(to: &mut Mesh, mesh: Mesh) {
    let first = to.positions.len() as u32;
    to.positions.extend(mesh.positions);
    let triangles = mesh.triangles.into_iter();
    to.triangles.extend(triangles.map(|t| t.map(|k| first + k)));
}
