//! glTF and GLB files, whole and broken.

use std::path::Path;

use glam::{DQuat, DVec3};
use serde_json::{Value, json};
use vkpt::scene::{MeshError, MeshFile, parse_mesh, read_mesh};

use super::gltf_writer::{Buffer, F32, I8, U8, U16, U32, glb};

pub fn read(document: &Value, bin: &[u8]) -> Result<MeshFile, MeshError> {
    parse_mesh(&glb(document, bin), Path::new("mesh.GLB"))
}

pub const CORNERS: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1.5, 0.], [0., 1., 0.]];
const SQUARE: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

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
fn primitives(document: &mut Value) -> &mut Vec<Value> {
    let primitives = &mut document["meshes"][0]["primitives"];
    primitives.as_array_mut().expect("an array")
}

fn vectors(rows: &[[f64; 3]]) -> Vec<DVec3> {
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
        warnings: Vec::new(),
    };
    assert_eq!(read(&document, &buffer.bytes).expect("a mesh"), expected);
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

/// Bytes of a buffer that are read in other ways: between others, as whole numbers, sparsely.
#[test]
fn accessors_of_every_kind() {
    let mut buffer = square();
    let small = buffer.vectors(
        I8,
        &[
            [0., 0., 0.],
            [127., 0., 0.],
            [127., -128., 0.],
            [0., 64., 0.],
        ],
    );
    let few = buffer.scalars(U8, &[1, 3]);
    let new = buffer.vectors(F32, &[[5., 5., 5.], [7., 7., 7.]]);
    let wide = buffer.interleaved(&CORNERS, 20);
    let (views, position) = (buffer.accessors.clone(), |i: usize| json!({"POSITION": i}));
    let view = |i: usize| views[i]["bufferView"].clone();
    let sparse = json!({
        "count": 2, "values": {"bufferView": view(new)},
        "indices": {"bufferView": view(few), "componentType": U8},
    });
    let mut next = buffer.accessors.len();
    let mut add = |mut accessor: Value, change: Value| {
        for (name, value) in change.as_object().expect("an object") {
            accessor[name] = value.clone();
        }
        buffer.accessors.push(accessor);
        next += 1;
        next - 1
    };
    let normalised = add(views[small].clone(), json!({"normalized": true}));
    let patched = add(views[0].clone(), json!({"sparse": sparse}));
    let zeros = json!({"count": 4, "type": "VEC3", "componentType": F32});
    let from_zero = add(zeros, json!({"sparse": sparse}));
    let z = [0., 0., 0.];
    let rows = [
        (wide, CORNERS),
        (small, [z, [127., 0., 0.], [127., -128., 0.], [0., 64., 0.]]),
        (
            normalised,
            [z, [1., 0., 0.], [1., -1., 0.], [0., 64. / 127., 0.]],
        ),
        (patched, [z, [5., 5., 5.], CORNERS[2], [7., 7., 7.]]),
        (from_zero, [z, [5., 5., 5.], z, [7., 7., 7.]]),
    ];
    for (accessor, expected) in rows {
        let primitive = json!({"attributes": position(accessor), "indices": 1});
        let mesh = read(&one(&buffer, primitive), &buffer.bytes).expect("a mesh");
        assert_eq!(mesh.positions, vectors(&expected), "accessor {accessor}");
    }
}

#[test]
fn buffers_in_the_file_and_beside_it_are_the_same() {
    let (document, bin) = plain();
    let expected = read(&document, &bin).expect("a mesh");
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("a b.bin"), [&bin[..], b"more"].concat()).expect("a file");
    let base64 = base64::Engine::encode(&base64::prelude::BASE64_STANDARD, &bin);
    let data = format!("data:application/octet-stream;base64,{base64}");
    for uri in ["a%20b.bin", "a b.bin", &data, data.trim_end_matches('=')] {
        let mut document = document.clone();
        document["buffers"][0]["uri"] = json!(uri);
        let path = folder.path().join("mesh.gltf");
        std::fs::write(&path, document.to_string()).expect("a file");
        let mut mesh = read_mesh(&path).expect(uri);
        let beside = match uri.starts_with("data:") {
            true => Vec::new(),
            false => vec![folder.path().join("a b.bin")],
        };
        assert_eq!(std::mem::take(&mut mesh.files), beside, "{uri}");
        assert_eq!(mesh, expected, "{uri}");
    }
}

/// p' = T·R·S·p of each node below the other, against quaternions and vectors by hand.
#[test]
fn nodes_are_placed_and_a_mesh_may_stand_in_several() {
    let (mut document, bin) = plain();
    document["nodes"] = json!([
        {"children": [1, 2], "translation": [1, 2, 3], "rotation": [0, 0, 0.6, 0.8]},
        {"mesh": 0, "scale": [2, 3, 4]},
        {"mesh": 0, "matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]},
        {"mesh": 0},
    ]);
    let mesh = read(&document, &bin).expect("a mesh");
    let turn = DQuat::from_xyzw(0.0, 0.0, f64::from(0.6_f32), f64::from(0.8_f32)).normalize();
    let parent = |p: DVec3| turn * p + DVec3::new(1.0, 2.0, 3.0);
    let scaled = |p: DVec3| parent(p * DVec3::new(2.0, 3.0, 4.0));
    let turned = |p: DVec3| parent(DVec3::new(5.0 - p.y, 6.0 + p.x, 7.0 + p.z));
    let corners = vectors(&CORNERS).into_iter();
    let expected: Vec<_> = corners
        .clone()
        .map(scaled)
        .chain(corners.map(turned))
        .collect();
    assert_eq!(mesh.positions.len(), expected.len());
    for (p, e) in mesh.positions.iter().zip(&expected) {
        assert!(p.distance(*e) < 1e-14, "{p} {e}");
    }
    assert_eq!(mesh.triangles[2..], [[4, 5, 6], [4, 6, 7]]);
}

/// The normals of the ellipsoid that a scaled unit sphere is: (x/a², y/b², z/c²), which points out whatever the signs
/// of a, b, c; and the triangle's own normal keeps to their side.
#[test]
fn normals_stay_outward_under_stretching_and_mirroring() {
    let points = [[1., 2., 2.], [2., 1., 2.], [2., 2., 1.]].map(|p| p.map(|x: f64| x / 3.0));
    let mut buffer = Buffer::default();
    buffer.vectors(F32, &points);
    let attributes = json!({"POSITION": 0, "NORMAL": 0});
    let mut document = one(&buffer, json!({"attributes": attributes}));
    let face = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
    let [a, b, c] = points.map(DVec3::from);
    assert!(face([a, b, c]).dot(a) > 0.0);
    for scale in [
        [1., 1., 1.],
        [3., 0.5, 1.],
        [-1., 1., 1.],
        [2., -0.25, 1.],
        [-3., -2., -1.],
    ] {
        document["nodes"][0]["scale"] = json!(scale);
        let mesh = read(&document, &buffer.bytes).expect("a mesh");
        let normals = mesh.normals.expect("normals");
        for (p, n) in mesh.positions.iter().zip(&normals) {
            let expected = (*p / DVec3::from(scale) / DVec3::from(scale)).normalize();
            assert!(n.distance(expected) < 1e-6, "{scale:?}: {n} {expected}");
        }
        let corners = mesh.triangles[0].map(|i| mesh.positions[i as usize]);
        assert!(face(corners).dot(corners[0]) > 0.0, "{scale:?}");
    }
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
fn the_default_scene_is_read_or_the_first_or_all_nodes() {
    let (mut document, bin) = plain();
    document["nodes"] = json!([
        {"mesh": 0}, {"mesh": 0, "translation": [1, 0, 0], "children": [2]}, {"mesh": 0, "translation": [1, 0, 0]}
    ]);
    let mut first = |scenes: Value, scene: Value| -> Vec<f64> {
        (document["scenes"], document["scene"]) = (scenes, scene);
        let mesh = read(&document, &bin).expect("a mesh");
        mesh.positions.iter().step_by(4).map(|p| p.x).collect()
    };
    let scenes = json!([{"nodes": [0]}, {"nodes": [1]}, {"nodes": [0, 2]}]);
    assert_eq!(first(scenes.clone(), json!(1)), [1.0, 2.0]);
    assert_eq!(first(scenes.clone(), json!(2)), [0.0, 1.0]);
    assert_eq!(first(scenes, Value::Null), [0.0]);
    assert_eq!(first(json!([]), Value::Null), [0.0, 1.0, 2.0]);
}

#[test]
fn what_is_not_done_is_warned_of() {
    let (mut document, bin) = plain();
    document["nodes"][0] = json!({"mesh": 0, "skin": 0, "translation": [9, 9, 9]});
    document["meshes"][0]["primitives"][0]["targets"] = json!([{"POSITION": 2}]);
    let mesh = read(&document, &bin).expect("a mesh");
    assert_eq!(mesh.positions, vectors(&CORNERS));
    assert_eq!(
        mesh.warnings,
        [
            "a skinned mesh is shown as it was bound",
            "morph targets are left out"
        ]
    );
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("skinned.glb");
    std::fs::write(&path, glb(&document, &bin)).expect("a file");
    let read = super::read_lines(&format!("mesh {} 0 0 0 1", path.display())).expect("a scene");
    let said: Vec<_> = read.warnings.iter().map(ToString::to_string).collect();
    let expected = mesh
        .warnings
        .iter()
        .map(|w| format!("{}: {w}", path.display()));
    assert_eq!(said, expected.collect::<Vec<_>>());
    assert_eq!(read.warnings[0].place.map(|place| place.line), Some(3));
}

#[test]
fn extensions_that_change_what_is_read_must_be_known() {
    let (mut document, bin) = plain();
    document["extensionsRequired"] = json!([
        "KHR_mesh_quantization",
        "KHR_materials_unlit",
        "KHR_texture_basisu",
        "KHR_lights_punctual"
    ]);
    // Nothing of this is looked at.
    document["textures"] = json!([{"extensions": {"KHR_texture_basisu": {"source": 0}}}]);
    document["images"] = json!([{"uri": "none.ktx2"}]);
    read(&document, &bin).expect("a mesh");
    for name in [
        "KHR_draco_mesh_compression",
        "EXT_meshopt_compression",
        "EXT_mesh_gpu_instancing",
        "VENDOR_x",
    ] {
        document["extensionsRequired"][3] = json!(name);
        let said = read(&document, &bin).expect_err(name).to_string();
        assert_eq!(
            said,
            format!("it requires the extension `{name}`, which is not read")
        );
    }
}
