//! Scene → prepared: camera, order of shapes, the eye's medium, warnings.

use std::path::Path;

use glam::DVec3;
use vkpt::prepared::{MaterialKind, NONE, Prepared, prepare};
use vkpt::settings::Settings;

fn prepared(text: &str) -> Prepared {
    let read = vkpt::scene::parse(text, Path::new("test.txt"), false).expect("a good scene");
    prepare(&read.scene, &Settings::default(), None).expect("few lights")
}

const GLASS: &str = "brdf 0 0 0 .04 .04 .04 .1 .5 .5 .5 1.5\n";
const MATTE: &str = "brdf .5 .5 .5 0 0 0 10\n";
const VIEW: &str = "screen 40 30\ncamera 0 0 0 .2\n";
const SKY: &str = "background 1 1 1\n";

/// The camera of the course's P4 scene, whose frame and field of view are known to three digits.
#[test]
fn the_course_camera_looks_where_the_course_says() {
    let camera = prepared(
        "screen 400 300\n\
         camera 5.553228 2.942755 2.900874 0.2 q 0.416981 0.279589 0.480987 0.718247\n",
    )
    .camera;
    let close = |v: DVec3, x, y, z| (v - DVec3::new(x, y, z)).abs().max_element() < 6e-4;
    assert!(
        close(camera.forward, -0.803, -0.458, -0.381),
        "{}",
        camera.forward
    );
    assert!(
        close(camera.up.normalize(), -0.330, -0.189, 0.925),
        "{}",
        camera.up
    );
    let degrees = |tangent: f64| 2.0 * tangent.atan().to_degrees();
    assert!((degrees(camera.up.length()) - 22.6).abs() < 0.05);
    assert!((degrees(camera.right.length()) - 29.9).abs() < 0.05);
}

#[test]
fn opaque_shapes_come_first_then_file_order() {
    let p = prepared(&format!(
        "{VIEW}{GLASS}sphere 0 0 0 1\n{MATTE}sphere 5 0 0 1\n{GLASS}sphere 9 0 0 1\n{MATTE}box 20 0 0 1 1 1\n"
    ));
    let lines: Vec<usize> = p.shapes.iter().map(|s| s.line).collect();
    assert_eq!(lines, [6, 10, 4, 8]);
}

#[test]
fn the_middle_of_the_scene_becomes_the_origin_and_its_size_about_1() {
    let p = prepared(&format!(
        "{VIEW}{MATTE}sphere 1e4 0 0 1\nsphere 1.0004e4 0 0 1\n"
    ));
    // The eye is 10,002 away, the power of two below it is 2¹³.
    assert_eq!(p.space.unit, 8192.0);
    assert_eq!(
        p.primitives.spheres[0].centre,
        DVec3::new(-2.0, 0.0, 0.0) / 8192.0
    );
    assert_eq!(p.primitives.spheres[0].radius, 1.0 / 8192.0);
    assert_eq!(p.camera.eye, DVec3::new(-10002.0, 0.0, 0.0) / 8192.0);
}

#[test]
fn the_eye_knows_the_medium_it_stands_in() {
    let medium = |shape: &str| {
        let p = prepared(&format!("{VIEW}{MATTE}sphere 9 9 9 1\n{GLASS}{shape}\n"));
        match p.eye_medium {
            NONE => None,
            m => Some(p.materials[m as usize].kind),
        }
    };
    let inside = [
        "sphere .5 0 0 1",
        "box -1 -1 -1 2 2 2",
        "cylinder 0 0 -1 0 0 2 1",
    ];
    let outside = [
        "sphere 1.5 0 0 1",
        "box .1 -1 -1 2 2 2",
        "cylinder 0 0 .1 0 0 2 1",
    ];
    for shape in inside {
        assert_eq!(
            medium(shape),
            Some(MaterialKind::RoughDielectric),
            "{shape}"
        );
    }
    for shape in outside {
        assert_eq!(medium(shape), None, "{shape}");
    }
}

#[test]
fn overlapping_glass_gives_one_warning() {
    let warnings = |shapes: &str| prepared(&format!("{VIEW}{SKY}{GLASS}{shapes}")).warnings;
    assert_eq!(
        warnings("sphere 0 0 0 1\nsphere 1.5 0 0 1\nsphere .7 0 0 1\n").len(),
        1
    );
    // Their bounds overlap, they do not.
    assert!(warnings("sphere 0 0 0 1\nsphere 1.5 1.5 -.5 1\nbox .8 .8 .8 1 1 1\n").is_empty());
}

/// 2⁹⁶ = 7.92e28: 2³² samples of it add up to 2¹²⁸, the end of single precision.
#[test]
fn a_radiance_whose_sum_overflows_gives_a_warning() {
    let warnings = |line: &str| prepared(&format!("{VIEW}{line}\nsphere 0 0 -5 1\n")).warnings;
    for line in ["light 1 7.93e28 1", "background 3e38 0 0"] {
        let warnings = warnings(line);
        assert_eq!(warnings.len(), 1, "{line}: {warnings:?}");
        assert!(
            warnings[0].starts_with("line 3: the radiance"),
            "{warnings:?}"
        );
    }
    for line in ["light 7.92e28 1 1", "background 7.92e28 0 0"] {
        assert!(warnings(line).is_empty(), "{line}");
    }
}

#[test]
fn lights_are_chosen_by_power() {
    let p = prepared(&format!(
        "{VIEW}light 1 1 1\nsphere 0 0 0 1\nlight 3 3 3\nsphere 5 0 0 1\nlight 0 0 0\nsphere 9 0 0 1\n"
    ));
    assert_eq!(p.lights.len(), 2, "a black emitter is no light");
    // A quarter of 2²⁴, to the one count that a quantised table may be off.
    assert!(p.light_cdf[1].abs_diff(1 << 22) <= 1, "{:?}", p.light_cdf);
    assert_eq!(p.light_cdf[2], 1 << 24);
}

/// Every number below is finite in single precision; the squares of some indices of refraction and the width of one picture
/// are not. Lengths and places are, in rendering space.
#[test]
fn scenes_that_overflow_single_precision_are_refused() {
    let glass = |ior: &str| format!("brdf 0 0 0 .04 .04 .04 .1 .5 .5 .5 {ior}\nsphere 0 0 0 1");
    let camera =
        |eye: &str, ry: &str| format!("camera {eye} {ry}\nsphere 0 0 0 1\nsphere 3e38 0 0 1");
    let large = [
        "box 3e38 0 0 -3e38 1 1",
        "box 3e38 0 0 3e38 1 1\nsphere -3e38 0 0 1",
        "cylinder 0 0 0 3e38 3e38 0 1",
        "mesh tests/data/scene/tetrahedron.ply 3e38 0 0 3e38\nsphere -3e38 0 0 1",
    ];
    let mut rows = large.map(|lines| (lines.to_owned(), None)).to_vec();
    rows.extend([
        (glass("1e19"), None),
        (glass("2e19"), Some("line 3: the index of refraction 2e19")),
        (glass("1e-19"), None),
        (
            glass("5e-20"),
            Some("line 3: the index of refraction 5e-20"),
        ),
        (camera("-3e38 0 0", "1"), None),
        (camera("0 0 0", "3e38"), Some("line 2: the camera ")),
    ]);
    for (lines, refused) in rows {
        let view = ["", "camera 0 0 0 .2\n"][usize::from(!lines.starts_with("camera"))];
        let text = format!("screen 40 30\n{view}{lines}");
        let read = vkpt::scene::parse(&text, Path::new("test.txt"), true).expect("a legal scene");
        let found = prepare(&read.scene, &Settings::default(), None);
        match (refused, found.map_err(|e| e.to_string())) {
            (None, Ok(p)) => assert!(within_2(&p), "{text}"),
            (Some(start), Err(found)) if found.starts_with(start) => {}
            (_, found) => panic!("{text}: {:?}", found.err()),
        }
    }
}

/// All lengths, and the corners of boxes and triangles, are at most 2 in rendering space (4 along a diagonal).
fn within_2(p: &Prepared) -> bool {
    let points = p.primitives.boxes.iter().flat_map(|b| [b.lo, b.hi]);
    let points = points.chain(p.primitives.triangles.iter().flat_map(|t| t.v));
    let points = points.chain(p.primitives.spheres.iter().map(|s| s.centre + s.radius));
    let mut points = points.chain(
        p.primitives
            .cylinders
            .iter()
            .map(|c| c.base + c.w * c.height),
    );
    points.all(|v| v.abs().max_element() <= 2.0)
}

/// 2·.2/30 of the distance is a pixel; at 1e-9 of it, 2⁻²³ covers a hundred.
#[test]
fn pixels_narrower_than_directions_give_a_warning() {
    for (ry, narrow) in [("1e-5", false), ("1e-9", true)] {
        let text = format!("screen 40 30\ncamera 0 0 9 {ry}\n{MATTE}sphere 0 0 0 1\n");
        let warnings = prepared(&text).warnings;
        let found = warnings.iter().any(|w| w.starts_with("line 2: the camera"));
        assert_eq!(found, narrow, "{warnings:?}");
    }
}

/// 2⁻²⁴ of its distance must be less than a hundredth of its size; for a mesh, of its largest extent.
#[test]
fn objects_too_small_for_their_distance_give_a_warning() {
    let tetrahedron = "mesh tests/data/scene/tetrahedron.ply";
    let rows = [
        ("sphere 1e4 0 0 1".to_owned(), false),
        ("sphere 1e6 0 0 1".to_owned(), true),
        ("box 1e6 0 0 9 9 1".to_owned(), true),
        ("box 1e4 0 0 1 1 1".to_owned(), false),
        ("box 1e4 0 0 1 1 1e-3".to_owned(), true),
        ("cylinder 1e4 0 0 0 0 1 1e-3".to_owned(), true),
        (format!("{tetrahedron} 1e4 0 0 1"), false),
        (format!("{tetrahedron} 1e4 0 0 1e-3"), true),
        ("sphere 0 0 0 1e-16".to_owned(), true),
    ];
    for (shape, small) in rows {
        // The two others keep the middle of the scene at the origin.
        let text = format!("{VIEW}{MATTE}{shape}\nsphere -2e6 0 0 9e3\nsphere 2e6 0 0 9e3\n");
        let warnings = prepared(&text).warnings;
        let found = warnings.iter().any(|w| w.contains("line 4 is"));
        assert_eq!(found, small, "{shape}: {warnings:?}");
    }
}

/// On a ball, a face, an edge, a mantle and a cap of glass; not next to them, and not on opaque shapes.
#[test]
fn an_eye_on_the_surface_of_glass_gives_a_warning() {
    let warns = |material: &str, shape: &str, eye: &str| {
        let text = format!("screen 40 30\ncamera {eye} .2\n{material}{shape}\n{SKY}");
        let warnings = prepared(&text).warnings;
        assert!(warnings.len() <= 1, "{warnings:?}");
        warnings
            .iter()
            .any(|w| w.contains("line 4") && w.contains("the eye is on"))
    };
    let (ball, cuboid, can) = (
        "sphere 0 0 0 1",
        "box 0 0 0 1 2 3",
        "cylinder 0 0 0 0 0 2 1",
    );
    for (shape, eye) in [
        (ball, "0 .6 .8"),
        (ball, "1.0000001 0 0"),
        (cuboid, ".5 1 3"),
        (cuboid, "1 2 1"),
        (can, "0 -1 1"),
        (can, ".5 0 2"),
    ] {
        assert!(warns(GLASS, shape, eye), "{shape}, {eye}");
        assert!(!warns(MATTE, shape, eye), "{shape}, {eye}");
    }
    for (shape, eye) in [
        (ball, "0 0 0"),
        (ball, "1.00001 0 0"),
        (cuboid, ".5 1 3.00001"),
        (cuboid, ".5 1 1.5"),
        (can, "0 0 1"),
        (can, ".9999 0 1"),
    ] {
        assert!(!warns(GLASS, shape, eye), "{shape}, {eye}");
    }
}

/// A ball of radius r fills r²/(4d²) of all directions from afar; a box of area A a mean of A/(16π d²). No part of a wall with
/// a sheen gathers light, nor does a wide gloss.
#[test]
fn lights_are_as_small_as_receivers_see_them() {
    let share = |text: &str| prepared(&format!("{VIEW}{text}")).light_share;
    let glass = "brdf 0 0 0 .04 .04 .04 .2 .9 .9 .9 1.5\nsphere 0 0 0 1\n";
    let ball = "light 1 1 1\nsphere 0 0 10 .5\n";
    let close = |found: Option<f64>, right: f64| {
        let found = found.expect("a share");
        assert!((found - right).abs() < 1e-6 * right, "{found} for {right}");
    };
    close(share(&format!("{ball}{glass}")), 0.25 / 400.0);
    let slab = "light 1 1 1\nbox -1 -2 9 2 4 2\n";
    close(
        share(&format!("{slab}{glass}")),
        40.0 / (1600.0 * std::f64::consts::PI),
    );
    // The smallest counts, and one within the glass fills none.
    close(share(&format!("{slab}{ball}{glass}")), 0.25 / 400.0);
    assert_eq!(
        share(&format!("light 1 1 1\nsphere .2 0 0 .1\n{glass}")),
        Some(0.0)
    );
    for (gloss, gathers) in [
        (".03 .03 .03 .1", false),
        (".5 .5 .5 .4", false),
        (".5 .5 .5 .1", true),
    ] {
        let text = format!("{ball}brdf .5 .5 .5 {gloss}\nsphere 0 0 0 1\n");
        assert_eq!(share(&text).is_some(), gathers, "{gloss}");
    }
    assert_eq!(share(glass), None);
}

#[test]
fn pictures_that_can_only_be_black_give_a_warning() {
    const NONE_SHINES: &str = "the scene has no lights";
    const SHUT_IN: &str = "the eye is inside the opaque shape of line 4";
    let far = format!("{MATTE}sphere 0 0 -5 1\n");
    let around = [
        format!("{MATTE}box -1 -1 -1 2 2 2\n"),
        format!("{MATTE}sphere 0 0 0 2\n"),
        format!("{MATTE}cylinder 0 0 -1 0 0 2 1\n"),
    ];
    let mut rows = vec![
        (far.clone(), Some(NONE_SHINES)),
        (String::new(), Some(NONE_SHINES)),
        (format!("light 0 0 0\n{far}"), Some(NONE_SHINES)),
        (format!("{far}light 0 0 1\nsphere 0 0 9 1\n"), None),
        (format!("{far}{SKY}"), None),
    ];
    for solid in &around {
        rows.push((solid.clone(), Some(NONE_SHINES)));
        rows.push((format!("{solid}{SKY}"), Some(SHUT_IN)));
        rows.push((
            format!("{solid}light 1 1 1\nsphere 0 0 -5 1\n"),
            Some(SHUT_IN),
        ));
        // A lamp that goes around it.
        rows.push((
            format!("{solid}light 1 1 1\nsphere 0 0 0 9\n"),
            Some(SHUT_IN),
        ));
        rows.push((
            format!("{solid}light 1 1 1\nbox -7 -7 -7 14 14 14\n"),
            Some(SHUT_IN),
        ));
        // Lamps inside, and one that comes through the wall.
        rows.push((format!("{solid}light 1 1 1\nsphere 0 0 -.5 .1\n"), None));
        rows.push((
            format!("{solid}light 1 1 1\nbox -.1 -.1 -9 .2 .2 8.5\n"),
            None,
        ));
    }
    for (rest, message) in rows {
        let warnings = prepared(&format!("{VIEW}{rest}")).warnings;
        match message {
            None => assert!(warnings.is_empty(), "{rest}: {warnings:?}"),
            Some(message) => {
                assert_eq!(warnings.len(), 1, "{rest}: {warnings:?}");
                assert!(warnings[0].starts_with(message), "{rest}: {warnings:?}");
            }
        }
    }
    // Glass, a lamp and a mesh around the eye are windows, a sky, or open.
    for around in [
        format!("{GLASS}sphere 0 0 0 2\n"),
        "light 1 1 1\nsphere 0 0 0 2\n".to_owned(),
        format!("{MATTE}mesh tests/data/scene/tetrahedron.ply -1 -1 -1 9\n"),
    ] {
        let warnings = prepared(&format!("{VIEW}{SKY}{around}")).warnings;
        assert!(warnings.is_empty(), "{around}: {warnings:?}");
    }
}
