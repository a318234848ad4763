//! Primitives of glTF files: their triangles and normals.

use std::path::Path;

use glam::DVec3;
use serde_json::{Value, json};
use vkpt::scene::{MeshError, MeshFile, parse_mesh};

use crate::common::gltf_writer::{Buffer, F32, U8, U16, U32, glb};

pub fn read(document: &Value, bin: &[u8]) -> Result<MeshFile, MeshError> {
    parse_mesh(&glb(document, bin), Path::new("mesh.GLB"))
}

pub const CORNERS: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1.5, 0.], [0., 1., 0.]];
pub const SQUARE: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

/// A square: accessor 0 has its corners, 1 its indices, 2 normals.
pub fn square() -> Buffer {
    let mut buffer = Buffer::default();
    buffer.vectors(F32, &CORNERS);
    buffer.scalars(U16, &[0, 1, 2, 0, 2, 3]);
    buffer.vectors(
        F32,
        &[[0., 0., 2.], [0., -4., 0.], [0., 0., 0.], [3., 0., 0.]],
    );
    buffer
}

/// The document of one node with one mesh of one primitive.
pub fn one(buffer: &Buffer, primitive: Value) -> Value {
    json!({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [primitive]}],
        "buffers": [{"byteLength": buffer.bytes.len()}],
        "bufferViews": buffer.views, "accessors": buffer.accessors,
    })
}

pub fn plain() -> (Value, Vec<u8>) {
    let buffer = square();
    let document = one(
        &buffer,
        json!({"attributes": {"POSITION": 0}, "indices": 1}),
    );
    (document, buffer.bytes)
}

/// The primitives of its mesh.
pub fn primitives(document: &mut Value) -> &mut Vec<Value> {
    let primitives = &mut document["meshes"][0]["primitives"];
    primitives.as_array_mut().expect("an array")
}

/// Adds an element to an array of a document.
pub fn add(document: &mut Value, array: &str, element: Value) {
    let array = document[array].as_array_mut().expect(array);
    array.push(element);
}

pub fn vectors(rows: &[[f64; 3]]) -> Vec<DVec3> {
    rows.iter().copied().map(DVec3::from).collect()
}

#[test]
fn a_primitive_is_read_with_its_normals() {
    let buffer = square();
    let attributes = json!({"POSITION": 0, "NORMAL": 2});
    let document = one(
        &buffer,
        json!({"attributes": attributes, "indices": 1, "material": 77}),
    );
    let expected = MeshFile {
        files: Vec::new(),
        positions: vectors(&CORNERS),
        normals: Some(vec![DVec3::Z, DVec3::NEG_Y, DVec3::ZERO, DVec3::X]),
        triangles: SQUARE.to_vec(),
        warnings: vec![
            "1 normal is zero or not finite: the faces' own normals are used there".into(),
        ],
    };
    assert_eq!(read(&document, &buffer.bytes).expect("a mesh"), expected);
}

#[test]
fn points_and_lines_are_skipped() {
    let (mut document, bin) = plain();
    for mode in 0..4 {
        let points = json!({"attributes": {"POSITION": 0}, "mode": mode});
        primitives(&mut document).push(points.clone());
        let alone = read(&one(&square(), points), &bin);
        assert_eq!(
            alone.expect_err("no mesh").to_string(),
            "it has no triangles"
        );
    }
    let mesh = read(&document, &bin).expect("a mesh");
    assert_eq!((mesh.positions.len(), mesh.triangles), (4, SQUARE.to_vec()));
}

#[test]
fn primitives_without_normals_are_flat_beside_those_that_have_some() {
    let (mut document, bin) = plain();
    primitives(&mut document)
        .push(json!({"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}));
    let normals = read(&document, &bin)
        .expect("a mesh")
        .normals
        .expect("normals");
    assert_eq!(normals[..4], [DVec3::ZERO; 4]);
    assert_eq!(normals[4], DVec3::Z);
}

#[test]
fn lists_strips_and_fans() {
    let mut buffer = square();
    buffer.scalars(U8, &[0, 1, 3, 2]);
    buffer.scalars(U32, &[0, 1, 2, 3]);
    buffer.scalars(U8, &[0, 1, 3, 3, 2, 2]);
    let rows: [(Value, &[[u32; 3]]); 6] = [
        (json!({"mode": 4, "indices": 1}), &SQUARE),
        (json!({"mode": 5, "indices": 3}), &[[0, 1, 3], [1, 2, 3]]),
        (json!({"mode": 6, "indices": 4}), &[[1, 2, 0], [2, 3, 0]]),
        (json!({"mode": 6}), &[[1, 2, 0], [2, 3, 0]]),
        (json!({"mode": 5}), &[[0, 1, 2], [1, 3, 2]]),
        (json!({"mode": 5, "indices": 5}), &[[0, 1, 3]]),
    ];
    for (mut primitive, triangles) in rows {
        primitive["attributes"] = json!({"POSITION": 0});
        let mesh = read(&one(&buffer, primitive.clone()), &buffer.bytes).expect("a mesh");
        assert_eq!(mesh.triangles, triangles, "{primitive}");
    }
}

/// The largest index of its type is no vertex (glTF 2.0, section 3.7.2.1).
#[test]
fn an_index_that_restarts_a_strip_is_refused() {
    for (kind, index) in [(U8, 0xff), (U16, 0xffff), (U32, u32::MAX)] {
        let mut buffer = Buffer::default();
        buffer.vectors(F32, &[CORNERS[0]; 256]);
        buffer.scalars(kind, &[0, 1, 2, index, 3, 4, 5]);
        for mode in [5, 6] {
            let primitive = json!({"attributes": {"POSITION": 0}, "indices": 1, "mode": mode});
            let message = read(&one(&buffer, primitive), &buffer.bytes).expect_err("a restart");
            let expected = format!(
                "mesh 0, primitive 0: its index {index} restarts a strip, which glTF 2.0 forbids: \
                 export it as a list of triangles"
            );
            assert_eq!(message.to_string(), expected);
        }
    }
    // In a list it is a vertex, if there is one.
    let mut buffer = Buffer::default();
    buffer.vectors(F32, &[CORNERS[0]; 256]);
    buffer.scalars(U8, &[0, 1, 255]);
    let list = json!({"attributes": {"POSITION": 0}, "indices": 1});
    let mesh = read(&one(&buffer, list), &buffer.bytes).expect("a mesh");
    assert_eq!(mesh.triangles, [[0, 1, 255]]);
}

#[test]
fn corners_that_are_too_few_for_a_triangle_are_left_out() {
    let mut buffer = square();
    for few in [&[0, 1, 2, 3][..], &[0, 1, 2, 3, 0], &[0, 1], &[0]] {
        buffer.scalars(U8, few);
    }
    let list = |indices: usize| json!({"attributes": {"POSITION": 0}, "indices": indices});
    let one_face = "1 face with fewer than three corners is skipped";
    for indices in [3, 4] {
        let mesh = read(&one(&buffer, list(indices)), &buffer.bytes).expect("a mesh");
        assert_eq!(mesh.triangles, [[0, 1, 2]]);
        assert_eq!(mesh.warnings, [one_face]);
    }
    for (indices, mode) in [(5, 4), (6, 4), (5, 5), (6, 5), (5, 6)] {
        let mut few = list(indices);
        few["mode"] = json!(mode);
        let mut document = one(&buffer, few);
        let message = read(&document, &buffer.bytes).expect_err("no mesh");
        assert_eq!(
            message.to_string(),
            format!("it has no triangles: {one_face}")
        );
        let few = primitives(&mut document)[0].clone();
        primitives(&mut document).extend([few, list(3), list(1)]);
        let mesh = read(&document, &buffer.bytes).expect("a mesh");
        assert_eq!(mesh.triangles.len(), 3);
        assert_eq!(
            mesh.warnings,
            ["3 faces with fewer than three corners are skipped"]
        );
    }
}

/// Of a triangle two have none; the fourth vertex is of no triangle.
#[test]
fn normals_without_a_direction_are_counted() {
    let (nan, inf) = (f64::NAN, f64::INFINITY);
    let mut buffer = Buffer::default();
    buffer.vectors(F32, &CORNERS);
    let normals = [[0., 0., 3.], [nan, 0., 1.], [0., -inf, 0.], [nan; 3]];
    buffer.vectors(F32, &normals);
    buffer.scalars(U8, &[0, 1, 2]);
    let primitive = json!({"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2});
    let mut document = one(&buffer, primitive);
    document["nodes"][0]["scale"] = json!([1, 2, -1]);
    let mesh = read(&document, &buffer.bytes).expect("a mesh");
    let expected = [DVec3::NEG_Z, DVec3::ZERO, DVec3::ZERO, DVec3::ZERO];
    assert_eq!(mesh.normals.expect("normals"), expected);
    assert_eq!(
        mesh.warnings,
        ["2 normals are zero or not finite: the faces' own normals are used there"]
    );
}

#[test]
fn a_position_that_is_not_finite_matters_where_a_triangle_uses_it() {
    let mut buffer = Buffer::default();
    let mut corners = CORNERS;
    corners[1][2] = f64::NAN;
    buffer.vectors(F32, &corners);
    buffer.scalars(U8, &[2, 3, 0]);
    buffer.scalars(U8, &[2, 3, 0, 0, 1, 2]);
    let primitive = |indices: usize| json!({"attributes": {"POSITION": 0}, "indices": indices});
    let mesh = read(&one(&buffer, primitive(1)), &buffer.bytes).expect("a mesh");
    assert_eq!((mesh.positions.len(), &mesh.warnings[..]), (4, &[][..]));
    assert_eq!(mesh.triangles, [[2, 3, 0]]);
    for corner in [0, 2, 3] {
        assert_eq!(mesh.positions[corner], DVec3::from(CORNERS[corner]));
    }
    // It has no place of its own in pictures: they are scaled to the box about all positions.
    assert_eq!(mesh.positions[1], DVec3::from(CORNERS[2]));
    let message = read(&one(&buffer, primitive(2)), &buffer.bytes).expect_err("not finite");
    assert_eq!(
        message.to_string(),
        "mesh 0, primitive 0: its vertex 1 is not finite in single precision"
    );
}

/// A warning comes with the line of the scene file.
#[test]
fn unsupported_features_give_warnings() {
    let (mut document, bin) = plain();
    primitives(&mut document)[0]["targets"] = json!([{"POSITION": 2}]);
    let mesh = read(&document, &bin).expect("a mesh");
    assert_eq!(mesh.positions, vectors(&CORNERS));
    assert_eq!(mesh.warnings, ["morph targets are skipped"]);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("morphed.glb");
    std::fs::write(&path, glb(&document, &bin)).expect("a file");
    let read = super::read_lines(&format!("mesh {} 0 0 0 1", path.display())).expect("a scene");
    let message: Vec<_> = read.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        message,
        [format!("{}: morph targets are skipped", path.display())]
    );
    assert_eq!(read.warnings[0].place.map(|place| place.line), Some(3));
}
