//! There and back.

use glam::DVec3;
use vkpt::prepared::{Material, MaterialKind};
use vkpt::scene::{Geometry, edges, signed_volume};

use super::*;
use crate::common::meshes::{cube, square};

/// A scene of one box of this material, and a lamp.
fn of(words: &str, material: &str) -> String {
    format!(
        "screen 400 300\ncamera 1 2 9 .3 y 10 x -5\nlight 9 8 7\nbox 0 5 0 1 1 1\n{words}\n{material}\nbox 1 2 3 -4 2 1\n"
    )
}

/// The fields of a material that kernels read, in single precision. Where nothing is mirrored there is no width.
fn seen(m: &Material) -> (MaterialKind, Vec<f32>) {
    use MaterialKind::{Black, Diffuse, NullInterface, RoughDielectric};
    let has_width = matches!(m.kind, MaterialKind::Glossy | RoughDielectric);
    let f0 = match m.kind {
        Black | Diffuse | NullInterface => DVec3::ZERO,
        _ => m.f0,
    };
    let alpha = if has_width { m.alpha } else { 0.0 };
    let [kd, f0, sigma, radiance] = [m.kd, f0, m.sigma, m.radiance].map(|v| v.to_array());
    let numbers = [kd, f0, sigma, radiance].into_iter().flatten();
    let numbers = numbers.chain([alpha]).chain(m.eta).chain(m.d);
    (m.kind, numbers.map(|x| x as f32).collect())
}

/// Whether two numbers are equal except for the last place.
fn near(a: f32, b: f32) -> bool {
    (a - b).abs() <= f32::EPSILON * a.abs()
}

#[test]
fn materials_come_back() {
    for material in [
        "brdf .7 .6 .5 0 0 0 1",
        "brdf .7 .6 .5 0 0 0 60",
        "brdf 0 0 0 .9 .8 .7 0",
        "brdf 0 0 0 .9 .8 .7 .25",
        "brdf .2 .3 .4 .05 .06 .07 .3",
        "brdf .2 .3 .4 1 1 1 0",
        "brdf 0 0 0 0 0 0 1",
        "brdf 0 0 0 .04 .05 .06 0 .5 .6 .7 1.5",
        "brdf 0 0 0 .04 .05 .06 .2 .5 0 1 1.25",
        "brdf 0 0 0 0 0 0 .2 1 1 1 2.4",
        "brdf 0 0 0 0 0 0 0 .5 .6 .7 1",
        "light 3 2 1",
        "light .3 .2 .1",
    ] {
        let [there, back] = there_and_back(&of("#", material)).map(|scene| ready(&scene));
        let [there, back] = [there, back].map(|p| {
            let last = p.shapes.iter().max_by_key(|shape| shape.line);
            seen(&p.materials[last.expect("two shapes").material as usize])
        });
        assert_eq!(there.0, back.0, "{material}");
        let equal = there.1.iter().zip(&back.1).all(|(a, b)| near(*a, *b));
        assert!(equal, "{material}: {there:?}, {back:?}");
    }
    // An exponent that a word turns into a width.
    let [there, back] = there_and_back(&of("distribution ggx", "brdf 0 0 0 .5 .5 .5 60"))
        .map(|scene| ready(&scene));
    let width = |p: &Prepared| p.materials[p.materials.len() - 1].alpha as f32;
    assert!(near(width(&there), width(&back)));
}

#[test]
fn a_wrong_material_would_be_noticed() {
    let materials = [
        "brdf 0 0 0 .04 .05 .06 .2 .5 .6 .7 1.5",
        "brdf 0 0 0 .04 .05 .06 .2 .5 .6 .7001 1.5",
    ];
    let [a, b] = materials.map(|material| {
        let [_, back] = there_and_back(&of("#", material));
        let back = ready(&back);
        seen(&back.materials[back.materials.len() - 1])
    });
    assert!(a.1.iter().zip(&b.1).any(|(a, b)| !near(*a, *b)));
}

#[test]
fn boxes_are_closed_meshes_of_the_same_corners() {
    let [_, back] = there_and_back(&of("#", "brdf .7 .6 .5 0 0 0 1"));
    let Geometry::Mesh(mesh) = &back.shapes[1].geometry else {
        panic!("a mesh")
    };
    let (lo, hi) = (mesh.positions.iter())
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(lo, hi), p| {
            (lo.min(*p), hi.max(*p))
        });
    assert_eq!(
        (lo, hi),
        (DVec3::new(-3.0, 2.0, 3.0), DVec3::new(1.0, 4.0, 4.0))
    );
    assert_eq!(
        (signed_volume(mesh), edges(mesh).open, mesh.triangles.len()),
        (8.0, 0, 12)
    );
}

#[test]
fn meshes_come_back_where_they_are() {
    let (open, closed) = (square(), cube());
    let [open, closed] = [&open, &closed].map(|file| file.path().display());
    let scene = format!(
        "screen 400 300\ncamera 0 0 9 .3\nlight 9 8 7\nmesh {closed} 0 5 0 .25\nbrdf .7 .6 .5 0 0 0 1\n\
         mesh {open} .1 .2 .3 1.7 x 20 z 30\nbrdf 0 0 0 .04 .04 .04 0 .5 .6 .7 1.5\nmesh {closed} 3 0 0 .3 y 40\n"
    );
    let [there, back] = there_and_back(&scene).map(|scene| ready(&scene));
    let vertices = |p: &Prepared| {
        let triangles = p.primitives.triangles.iter();
        triangles
            .flat_map(|t| t.v.map(|v| v.as_vec3().to_array()))
            .flatten()
            .collect::<Vec<f32>>()
    };
    let [a, b] = [vertices(&there), vertices(&back)];
    assert_eq!(a.len(), 9 * (12 + 2 + 12));
    // In rendering space, where the scene's size is about 1.
    let off = a
        .iter()
        .zip(&b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f32::max);
    assert!(a.len() == b.len() && off <= f32::EPSILON, "{off}");
    assert!(vertices(&ready(&there_and_back(&scene.replace(".1 .2", ".2 .2"))[1])) != b);
}

#[test]
fn the_camera_comes_back() {
    let [there, back] = there_and_back(&of("#", "brdf .7 .6 .5 0 0 0 1"));
    assert_eq!(
        (there.screen.width, there.screen.height),
        (back.screen.width, back.screen.height)
    );
    let eye = |s: &Scene| s.camera.eye.to_array();
    assert_eq!(eye(&there), eye(&back));
    assert!((there.camera.ry - back.camera.ry).abs() < 1e-15);
    let turned = there
        .camera
        .orientation
        .angle_between(back.camera.orientation);
    assert!(turned < 1e-7, "{turned}");
}

#[test]
fn the_first_of_two_faces_in_one_place_is_there() {
    let covered = |z: &str| {
        let scene = of("#", "brdf .7 .6 .5 0 0 0 1");
        // Its upper face is flush with that of the box before it where z is 3.5.
        let [_, back] = there_and_back(&format!(
            "{scene}brdf .1 .2 .3 0 0 0 1\nbox -1 2.5 {z} 1 1 .5\n"
        ));
        let back = ready(&back);
        let by = |shape: usize| {
            let own = &back.shapes[shape];
            let first = |prim| back.primitives.coincident.of(shape as u32, prim).first();
            let face = own.faces().find_map(first)?;
            Some(back.shapes[face.shape as usize].line < own.line)
        };
        [1, 2].map(by)
    };
    assert_eq!(covered("3.5"), [None, Some(true)]);
    assert_eq!(covered("3.4"), [None, None]);
}
