//! The meaning of legal scenes.

use std::path::Path;

use glam::{DQuat, DVec3};
use vkpt::scene::{Brdf, Camera, Geometry, Material, MaterialKind, Screen, parse};
use vkpt::settings::{Distribution, Fresnel};

use super::read_lines;

/// The material of each shape of a scene of `lines`, which must read without a warning.
fn materials(lines: &str) -> Vec<Material> {
    let read =
        read_lines(lines).unwrap_or_else(|errors| panic!("{lines}: {:?}", errors.diagnostics));
    assert!(read.warnings.is_empty(), "{lines}: {:?}", read.warnings);
    let of_shape = |shape: &vkpt::scene::Shape| read.scene.materials[shape.material].clone();
    read.scene.shapes.iter().map(of_shape).collect()
}

fn brdf(material: &Material) -> &Brdf {
    match &material.kind {
        MaterialKind::Brdf(brdf) => brdf,
        MaterialKind::Light(radiance) => panic!("a light of {radiance}"),
    }
}

#[test]
fn white_space_line_ends_comments_and_a_byte_order_mark_do_not_matter() {
    let plain = "screen 4 3\ncamera 1 2 3 0.5\nsphere 0 0 0 1\nbox 0 0 0 1 1 1";
    let dressed = "\u{feff}\r\n# sphere\r\n\t screen\t4  3 \r\ncamera 1 2 3 0.5\r\n\r\n #mesh foo.ply\r\n\
                   \u{c}sphere 0 0 0 1\r\n  #\r\nbox 0 0 0 1 1 1\r\n";
    let read = |text| {
        parse(text, Path::new("a.scn"), true)
            .expect("a legal scene")
            .scene
    };
    let (plain, dressed) = (read(plain), read(dressed));
    assert_eq!(
        (plain.screen, plain.camera),
        (dressed.screen, dressed.camera)
    );
    let lines =
        |scene: &vkpt::scene::Scene| scene.shapes.iter().map(|s| s.line).collect::<Vec<_>>();
    assert_eq!((lines(&plain), lines(&dressed)), (vec![3, 4], vec![7, 9]));
    // Old Macintosh files end their lines in a carriage return.
    let old = "screen 4 3\rcamera 1 2 3 0.5\rsphere 0 0 0 1\rbox 0 0 0 1 1 1\r";
    assert_eq!(lines(&read(old)), [3, 4]);
}

#[test]
fn screen_camera_and_background() {
    let text = "screen 400 300\ncamera 1 -2.5 3e1 .2\nbackground 1 0.5 0\nambient 1 nonsense";
    let scene = parse(text, Path::new("a.scn"), true)
        .expect("a legal scene")
        .scene;
    assert_eq!(
        scene.screen,
        Screen {
            width: 400,
            height: 300
        }
    );
    let camera = Camera {
        eye: DVec3::new(1.0, -2.5, 30.0),
        ry: 0.2,
        orientation: DQuat::IDENTITY,
    };
    assert_eq!(scene.camera, camera);
    assert_eq!(scene.background, DVec3::new(1.0, 0.5, 0.0));
    assert!(scene.shapes.is_empty() && scene.materials.is_empty());
}

#[test]
fn a_lens_stands_anywhere_and_the_last_counts() {
    let lens = |text: &str| {
        let read = parse(text, Path::new("a.scn"), false).expect("a legal scene");
        (
            read.scene.lens.map(|l| (l.line, l.radius, l.focus)),
            read.warnings.len(),
        )
    };
    let view = "screen 4 3\ncamera 0 0 0 1";
    assert_eq!(lens(view), (None, 0));
    assert_eq!(
        lens(&format!("lens .25 8\n{view}")),
        (Some((1, 0.25, 8.0)), 0)
    );
    assert_eq!(
        lens(&format!("{view}\nsphere 0 0 0 1\nlens 0 1e9")),
        (Some((4, 0.0, 1e9)), 0)
    );
    assert_eq!(
        lens(&format!("lens 1 2\n{view}\nlens 3 4")),
        (Some((4, 3.0, 4.0)), 1)
    );
}

#[test]
fn shapes() {
    let lines = "sphere 1 2 3 4\nbox 1 2 3 -4 5 -6\ncylinder 1 2 3 0 0 -2 .5";
    let shapes = read_lines(lines).expect("a legal scene").scene.shapes;
    let corner = DVec3::new(1.0, 2.0, 3.0);
    let expected = [
        Geometry::Sphere {
            centre: corner,
            radius: 4.0,
        },
        Geometry::Box {
            corner,
            diagonal: DVec3::new(-4.0, 5.0, -6.0),
        },
        Geometry::Cylinder {
            base: corner,
            axis: DVec3::new(0.0, 0.0, -2.0),
            radius: 0.5,
        },
    ];
    let text = |geometry: &Geometry| format!("{geometry:?}");
    let read: Vec<_> = shapes.iter().map(|shape| text(&shape.geometry)).collect();
    assert_eq!(read, expected.iter().map(text).collect::<Vec<_>>());
    assert_eq!(
        shapes.iter().map(|shape| shape.line).collect::<Vec<_>>(),
        [3, 4, 5]
    );
}

#[test]
fn a_shape_takes_the_last_material_before_it() {
    let lines = "sphere 0 0 0 1\nbrdf 1 0 0 0 0 0 1\nlight 1 2 3\nsphere 0 0 0 1\nsphere 0 0 0 2\n\
                 light 9 9 9\nbrdf .1 .2 .3 .4 .5 .6 .7\nsphere 0 0 0 3";
    let read = read_lines(lines).expect("a legal scene").scene;
    assert_eq!(
        read.materials.len(),
        3,
        "a material that no shape takes is not kept"
    );
    assert_eq!(
        read.shapes.iter().map(|s| s.material).collect::<Vec<_>>(),
        [0, 1, 1, 2]
    );
    let materials = materials(lines);
    assert_eq!(
        materials.iter().map(|m| m.line).collect::<Vec<_>>(),
        [0, 5, 5, 9]
    );
    let first = brdf(&materials[0]);
    let orange = (DVec3::new(1.0, 0.5, 0.0), DVec3::ONE, 1.0, DVec3::ZERO);
    assert_eq!((first.kd, first.ks, first.alpha, first.kt), orange);
    assert_eq!(
        materials[1].kind,
        MaterialKind::Light(DVec3::new(1.0, 2.0, 3.0))
    );
    let last = brdf(&materials[3]);
    assert_eq!(
        (last.kd, last.ks),
        (DVec3::new(0.1, 0.2, 0.3), DVec3::new(0.4, 0.5, 0.6))
    );
    assert_eq!((last.alpha, last.kt), (0.7, DVec3::ZERO));
}

#[test]
fn eleven_numbers_transmit_and_alpha_may_be_zero() {
    let glass = &materials("brdf 0 0 0 .04 .04 .04 0  .9 .5 1 1.5\nsphere 0 0 0 1")[0];
    let glass = brdf(glass);
    assert_eq!(
        (glass.alpha, glass.kt, glass.ior),
        (0.0, DVec3::new(0.9, 0.5, 1.0), 1.5)
    );
}

#[test]
fn words_apply_to_the_materials_that_follow() {
    let lines = "brdf 0 0 0 1 1 1 1\nsphere 0 0 0 1\ndistribution beckmann\nsphere 0 0 0 1\n\
                 brdf 0 0 0 1 1 1 1\nsphere 0 0 0 1\ndistribution ggx\nfresnel exact\n\
                 brdf 0 0 0 1 1 1 1\nsphere 0 0 0 1\ndistribution phong\nfresnel schlick\n\
                 brdf 0 0 0 1 1 1 1\nsphere 0 0 0 1\ndistribution auto\n\
                 brdf 0 0 0 1 1 1 1\nsphere 0 0 0 1";
    let words: Vec<_> = materials(lines)
        .iter()
        .map(|m| (brdf(m).distribution, brdf(m).fresnel))
        .collect();
    let (exact, schlick) = (Some(Fresnel::Exact), Some(Fresnel::Schlick));
    let expected = [
        (None, None),
        (None, None),
        (Some(Distribution::Beckmann), None),
        (Some(Distribution::Ggx), exact),
        (Some(Distribution::Phong), schlick),
        (None, schlick),
    ];
    assert_eq!(words, expected);
}

/// The image of a vector of the camera's frame under its `orientation`.
fn turned(orientation: &str, v: DVec3) -> DVec3 {
    let text = format!("screen 4 3\ncamera 0 0 0 1 {orientation}");
    let scene = parse(&text, Path::new("a.scn"), true)
        .expect("a legal orientation")
        .scene;
    assert!(
        (scene.camera.orientation.length() - 1.0).abs() < 1e-15,
        "{orientation}"
    );
    scene.camera.orientation * v
}

#[test]
fn orientations_turn_the_right_way_and_the_rightmost_acts_first() {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let rows = [
        ("", x, x),
        ("x 90", y, z),
        ("y 90", z, x),
        ("z 90", x, y),
        ("z -90", y, x),
        ("a 90 0 0 2", x, y),
        ("a 120 1 1 1", x, y),
        ("a 120 1 1 1", y, z),
        // (w, x, y, z) = (1, 0, 0, 1): 90° about z.
        ("q 1 0 0 1", x, y),
        // Were the leftmost to act first, x would go to y.
        ("x 90 z 90", x, z),
        ("z 90 x 90", x, y),
        ("z 90 x 90", y, z),
        ("x 90 y 90 z 90", x, z),
        ("q .5 .5 .5 .5 x 90", y, x),
    ];
    for (orientation, from, to) in rows {
        let error = (turned(orientation, from) - to).length();
        assert!(
            error < 1e-15,
            "{orientation}: {from} goes to {}",
            turned(orientation, from)
        );
    }
}
