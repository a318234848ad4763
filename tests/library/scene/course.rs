//! The course's own scenes, as they lie in ../shared; skipped where that folder is absent.

use std::path::{Path, PathBuf};

use glam::DVec3;
use vkpt::scene::{Geometry, Read, Scene, read};

/// The scene `name` and what was said of it; `None`, and a line that says so, without the shared folder.
fn course(name: &str) -> Option<Read> {
    let path = PathBuf::from("../shared/scenes").join(name);
    if !path.exists() {
        println!("skipped: {} is absent", path.display());
        return None;
    }
    Some(read(&path, false).unwrap_or_else(|errors| panic!("{errors}: {:?}", errors.diagnostics)))
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

/// By hand: a light, six walls, a table of one slab and four corners of a ball and two bars, then what stands
/// on the table, then two letters.
#[test]
fn shapes_and_materials_are_those_counted_by_hand() {
    let rows = [
        ("p2-diffuse.scn", [1 + 4 + 1, 6 + 1, 8, 2], 11),
        ("p3-reflection.scn", [1 + 4 + 1, 6 + 1, 8, 2], 11),
        ("p4-transmission.scn", [1 + 4 + 2, 6 + 1, 8, 2], 12),
    ];
    for (name, shapes, materials) in rows {
        let Some(read) = course(name) else { continue };
        assert_eq!(kinds(&read.scene), shapes, "{name}");
        assert_eq!(read.scene.materials.len(), materials, "{name}");
        assert_eq!(
            (read.scene.screen.width, read.scene.screen.height),
            (400, 300),
            "{name}"
        );
    }
}

#[test]
fn p2_has_one_warning_and_the_others_none() {
    let Some(p2) = course("p2-diffuse.scn") else {
        return;
    };
    let [warning] = p2.warnings.as_slice() else {
        panic!("{:?}", p2.warnings)
    };
    let place = warning.place.expect("a place");
    assert_eq!(
        (place.line, place.column, place.length),
        (3, 26, "2.900874b".len())
    );
    assert_eq!(warning.message, "`2.900874b` is read as 2.900874");
    assert_eq!(p2.scene.camera.eye.z, 2.900874);
    for name in ["p3-reflection.scn", "p4-transmission.scn"] {
        assert!(
            course(name).is_none_or(|read| read.warnings.is_empty()),
            "{name}"
        );
    }
    let path = Path::new("../shared/scenes/p2-diffuse.scn");
    let strict = read(path, true).expect_err("a warning is an error");
    assert_eq!(
        strict.to_string(),
        format!("{}: 1 error, of them 1 warning by --strict", path.display())
    );
}

/// The format page gives them for the official P4 camera, to three digits.
#[test]
fn p4_camera_looks_where_the_course_says() {
    let Some(p4) = course("p4-transmission.scn") else {
        return;
    };
    let camera = p4.scene.camera;
    let rows = [
        (
            camera.orientation * DVec3::NEG_Z,
            DVec3::new(-0.803, -0.458, -0.381),
        ),
        (
            camera.orientation * DVec3::Y,
            DVec3::new(-0.330, -0.189, 0.925),
        ),
    ];
    for (seen, said) in rows {
        assert!(
            (seen - said).abs().max_element() <= 5e-4,
            "{seen} is not {said}"
        );
    }
    let degrees = |tangent: f64| 2.0 * tangent.atan().to_degrees();
    let aspect = f64::from(p4.scene.screen.width) / f64::from(p4.scene.screen.height);
    assert!((degrees(camera.ry) - 22.6).abs() <= 0.05);
    assert!((degrees(camera.ry * aspect) - 29.9).abs() <= 0.05);
}

/// Two quads each for X, three for Y, as their headers say.
#[test]
fn the_letters_are_read_from_beside_the_scene() {
    let Some(p4) = course("p4-transmission.scn") else {
        return;
    };
    let meshes: Vec<_> = p4
        .scene
        .shapes
        .iter()
        .filter_map(|shape| match &shape.geometry {
            Geometry::Mesh(mesh) => Some(mesh),
            _ => None,
        })
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
        DVec3::new(f64::from(0.452666_f32), f64::from(1.443985_f32), 0.0)
    );
}
