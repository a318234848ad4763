//! Shapes, lights and mesh files.

use std::path::Path;

use vkpt::scene::parse_mesh;

use super::*;
use crate::common::meshes::cube;

/// A scene whose line 4 is a shape of this material.
fn of(material: &str, shape: &str) -> String {
    format!("screen 8 8\ncamera 0 0 90 1\n{material}\n{shape}\n")
}

const GREY: &str = "brdf .5 .5 .5 0 0 0 1";

#[test]
fn a_ball_has_its_centre_and_radius() {
    let exported = export(&of(GREY, "sphere 1 2 3 .5"));
    let document = document(&exported);
    let ball = plugins(&document, "shape")[0];
    assert_eq!(kind(&ball), "sphere");
    check(&ball, "radius", &[0.5]);
    let centre = parameter(&ball, "center");
    let words = ["x", "y", "z"].map(|axis| centre.attribute(axis));
    assert_eq!(words, [Some("1"), Some("2"), Some("3")]);
}

#[test]
fn a_box_is_a_cube_from_minus_1_to_1_for_every_diagonal() {
    for shape in ["box 1 2 3 4 2 1", "box 5 2 4 -4 2 -1"] {
        let exported = export(&of(GREY, shape));
        let document = document(&exported);
        let cube = plugins(&document, "shape")[0];
        assert_eq!(kind(&cube), "cube");
        check_matrix(
            &cube,
            &[
                2.0, 0.0, 0.0, 3.0, 0.0, 1.0, 0.0, 3.0, 0.0, 0.0, 0.5, 3.5, 0.0, 0.0, 0.0, 1.0,
            ],
        );
    }
}

#[test]
fn a_cylinder_is_closed_by_discs_that_look_outwards() {
    let exported = export(&of("light 3 2 1", "cylinder 1 0 0 0 0 2 .5"));
    let document = document(&exported);
    let [side, top, base] = plugins(&document, "shape")[..] else {
        panic!("three pieces")
    };
    assert_eq!(
        [side, top, base].map(|s| kind(&s)),
        ["cylinder", "disk", "disk"]
    );
    check(&side, "radius", &[0.5]);
    let end = parameter(&side, "p1");
    assert_eq!(
        ["x", "y", "z"].map(|a| end.attribute(a)),
        ["1", "0", "2"].map(Some)
    );
    check_matrix(
        &top,
        &[
            0.5, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 1.0,
        ],
    );
    let matrix = parameter(&base, "to_world");
    let matrix = matrix
        .first_element_child()
        .and_then(|m| m.attribute("value"));
    let m = numbers(matrix.expect("a matrix"));
    // The image of Z, and that of the origin.
    same(&[m[2], m[6], m[10]], &[0.0, 0.0, -1.0], "normal");
    same(&[m[3], m[7], m[11]], &[1.0, 0.0, 0.0], "centre");
    for piece in [side, top, base] {
        let light = piece.children().find(|n| n.has_tag_name("emitter"));
        let light = light.expect("every piece shines");
        assert_eq!(kind(&light), "area");
        check(&light, "radiance", &[3.0, 2.0, 1.0]);
    }
}

#[test]
fn a_mesh_is_a_file_beside_with_its_triangles_in_place() {
    let file = cube();
    let mesh = file.path().display();
    let exported = export(&of(GREY, &format!("mesh {mesh} 10 0 0 2 z 90")));
    let document = document(&exported);
    let shape = plugins(&document, "shape")[0];
    assert_eq!(
        (kind(&shape), word(&shape, "filename")),
        ("ply", "a & b-4.ply")
    );
    assert_eq!(word(&shape, "face_normals"), "true");
    let [written] = &exported.meshes[..] else {
        panic!("one mesh")
    };
    assert_eq!(written.name, "a & b-4.ply");
    let given = vkpt::scene::read_mesh(file.path()).expect("the cube");
    let back = parse_mesh(&written.bytes, Path::new("a.ply")).expect("a PLY file");
    assert_eq!(back.triangles, given.triangles);
    assert_eq!(back.positions.len(), given.positions.len());
    // Turned by 90° about Z, then twice as large, then moved.
    for (p, q) in given.positions.iter().zip(&back.positions) {
        same(
            &q.to_array(),
            &[10.0 - 2.0 * p.y, 2.0 * p.x, 2.0 * p.z],
            "a vertex",
        );
    }
}
