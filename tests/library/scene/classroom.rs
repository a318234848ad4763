//! Scenes as courses write them: old commands, numbers with trailing junk, 11-number opaque materials, flat letters.

use glam::DVec3;
use vkpt::scene::{Geometry, Mesh, Read, Scene, read};

use crate::common::data::data;

/// `tests/data/classroom/NAME` and the messages about it.
fn classroom(name: &str) -> Read {
    let path = data("classroom").join(name);
    read(&path, false).unwrap_or_else(|errors| panic!("{errors}: {:?}", errors.diagnostics))
}

/// Spheres, boxes, cylinders and meshes.
fn kinds(scene: &Scene) -> [usize; 4] {
    let mut kinds = [0; 4];
    for shape in &scene.shapes {
        let kind = match shape.geometry {
            Geometry::Sphere { .. } => 0,
            Geometry::Box { .. } => 1,
            Geometry::Cylinder { .. } => 2,
            Geometry::Mesh(_) => 3,
        };
        kinds[kind] += 1;
    }
    kinds
}

/// By hand: a light, six walls, a table of one slab and four corners of a ball and two bars, then the objects on the table,
/// then two letters. The material at the end has no shape.
#[test]
fn shapes_and_materials_are_those_counted_by_hand() {
    let rows = [
        ("diffuse.scn", [1 + 4 + 1, 6 + 1, 8, 2], 11),
        ("glass.scn", [1 + 4 + 2, 6 + 1, 8, 2], 12),
    ];
    for (name, shapes, materials) in rows {
        let scene = classroom(name).scene;
        assert_eq!(kinds(&scene), shapes, "{name}");
        assert_eq!(scene.materials.len(), materials, "{name}");
        let size = (scene.screen.width, scene.screen.height);
        assert_eq!(size, (400, 300), "{name}");
    }
}

#[test]
fn trailing_junk_is_one_warning_and_glass_has_none() {
    let diffuse = classroom("diffuse.scn");
    let [warning] = diffuse.warnings.as_slice() else {
        panic!("{:?}", diffuse.warnings)
    };
    let place = warning.place.expect("a place");
    assert_eq!(
        (place.line, place.column, place.length),
        (3, 26, "3.200000b".len())
    );
    assert_eq!(warning.message, "`3.200000b` is read as 3.200000");
    assert_eq!(diffuse.scene.camera.eye.z, 3.2);
    let glass = classroom("glass.scn").warnings;
    assert!(glass.is_empty(), "{glass:?}");
    let path = data("classroom/diffuse.scn");
    let strict = read(&path, true).expect_err("a warning is an error");
    assert_eq!(
        strict.to_string(),
        format!(
            "{}: 1 error, including 1 warning by --strict",
            path.display()
        )
    );
}

/// The quaternion, whose norm is 1.0004, was made to look from the eye at (0.1, 0, 0.55) with the horizon level.
#[test]
fn the_camera_looks_where_it_was_aimed() {
    let camera = classroom("glass.scn").scene.camera;
    let forward = (DVec3::new(0.1, 0.0, 0.55) - camera.eye).normalize();
    let right = forward.cross(DVec3::Z).normalize();
    for (axis, expected) in [
        (DVec3::NEG_Z, forward),
        (DVec3::X, right),
        (DVec3::Y, right.cross(forward)),
    ] {
        let seen = camera.orientation * axis;
        // The file has six digits.
        assert!(
            (seen - expected).abs().max_element() <= 2e-6,
            "{seen} is not {expected}"
        );
    }
    assert_eq!(camera.ry, 0.2);
}

/// Two quads for T, three for F, as their headers say.
#[test]
fn the_letters_are_read_from_beside_the_scene() {
    let glass = classroom("glass.scn").scene;
    let mesh = |geometry| match geometry {
        Geometry::Mesh(mesh) => Some(mesh),
        _ => None,
    };
    let meshes: Vec<Mesh> = glass
        .shapes
        .into_iter()
        .filter_map(|shape| mesh(shape.geometry))
        .collect();
    let sizes: Vec<_> = meshes
        .iter()
        .map(|m| (m.positions.len(), m.triangles.len()))
        .collect();
    assert_eq!(sizes, [(8, 4), (12, 6)]);
    assert!(
        meshes
            .iter()
            .all(|mesh| mesh.normals.is_none() && mesh.scale == 0.1)
    );
    assert_eq!(
        meshes[0].positions[0],
        DVec3::new(f64::from(-0.9_f32), f64::from(1.15_f32), 0.0)
    );
}
