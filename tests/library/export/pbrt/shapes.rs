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

/// Where the transform puts a point.
fn placed(m: &[f64], p: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| p[0] * m[i] + p[1] * m[4 + i] + p[2] * m[8 + i] + m[12 + i])
}

#[test]
fn a_ball_has_its_place_and_radius() {
    let exported = export(&of(GREY, "sphere 1 2 3 .5"));
    let m = &exported.only("ConcatTransform").numbers;
    same(&placed(m, [0.0; 3]), &[1.0, 2.0, 3.0], "its middle");
    assert_eq!(exported.only("Shape").plugin(), "sphere");
    check(exported.only("Shape"), "float radius", &[0.5]);
}

#[test]
fn a_box_is_12_triangles_seen_from_outside_for_every_diagonal() {
    for shape in ["box 1 2 3 4 2 1", "box 5 2 4 -4 2 -1"] {
        let exported = export(&of(GREY, shape));
        let mesh = exported.only("Shape");
        assert_eq!(mesh.plugin(), "trianglemesh");
        let points = mesh.numbers_of("point3 P");
        let corner = |i: &f64| glam::DVec3::from_slice(&points[3 * *i as usize..]);
        let indices = mesh.numbers_of("integer indices");
        let triangles: Vec<_> = indices
            .chunks(3)
            .map(|t| [corner(&t[0]), corner(&t[1]), corner(&t[2])])
            .collect();
        assert_eq!(triangles.len(), 12);
        // Gauss: the volume is a sixth of the sum of determinants, the surface half that of lengths; both known of a box.
        let volume: f64 = triangles
            .iter()
            .map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0)
            .sum();
        let area: f64 = triangles
            .iter()
            .map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0)
            .sum();
        same(&[volume, area], &[8.0, 28.0], shape);
        let middle = glam::DVec3::new(3.0, 3.0, 3.5);
        let outwards = |[a, b, c]: &[glam::DVec3; 3]| (b - a).cross(c - a).dot(a - middle) > 0.0;
        assert!(triangles.iter().all(outwards), "{shape}");
    }
}

#[test]
fn a_cylinder_is_closed_by_discs_that_look_outwards() {
    let exported = export(&of("light 3 3 3", "cylinder 1 0 0 2 0 0 .5"));
    let m = &exported.only("ConcatTransform").numbers;
    same(&placed(m, [0.0; 3]), &[1.0, 0.0, 0.0], "base");
    same(&placed(m, [0.0, 0.0, 2.0]), &[3.0, 0.0, 0.0], "top");
    let [side, top, base] = exported.all("Shape")[..] else {
        panic!("three pieces")
    };
    assert_eq!(
        [side, top, base].map(Statement::plugin),
        ["cylinder", "disk", "disk"]
    );
    check(side, "float zmin", &[0.0]);
    check(side, "float zmax", &[2.0]);
    check(top, "float height", &[2.0]);
    [side, top, base]
        .iter()
        .for_each(|piece| check(piece, "float radius", &[0.5]));
    // A disc looks along +Z: that of the base is turned, and no other.
    let directives: Vec<&str> = exported.statements.iter().map(|s| &*s.directive).collect();
    let at = directives
        .iter()
        .position(|d| *d == "ReverseOrientation")
        .expect("one is turned");
    assert_eq!(
        directives[at - 1..],
        ["Shape", "ReverseOrientation", "Shape", "AttributeEnd"]
    );
    let light = exported.only("AreaLightSource");
    check(light, "rgb L", &[3.0; 3]);
    assert_eq!(light.values("bool twosided"), ["true"]);
}

#[test]
fn a_mesh_is_a_file_beside_with_its_triangles_in_place() {
    let file = cube();
    let mesh = file.path().display();
    let exported = export(&of(GREY, &format!("mesh {mesh} 10 0 0 2 z 90")));
    assert_eq!(
        exported.only("Shape").values("string filename"),
        ["a & b-4.ply"]
    );
    let [written] = &exported.meshes[..] else {
        panic!("one mesh")
    };
    assert_eq!(written.name, "a & b-4.ply");
    let back = parse_mesh(&written.bytes, Path::new("a.ply")).expect("a PLY file");
    let given = vkpt::scene::read_mesh(file.path()).expect("the cube");
    assert_eq!(back.triangles, given.triangles);
    for (p, q) in given.positions.iter().zip(&back.positions) {
        same(
            &q.to_array(),
            &[10.0 - 2.0 * p.y, 2.0 * p.x, 2.0 * p.z],
            "a vertex",
        );
    }
}
