//! Skins of glTF files at rest: p' = Σ wⱼ·Jⱼ·p, by hand.

use glam::DVec3;
use serde_json::{Value, json};

use super::gltf::{CORNERS, one, read, vectors};
use super::gltf_bad::never_panics;
use crate::common::gltf_writer::{Buffer, F32, U8, U16};

const ONE: [f64; 16] = [
    1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.,
];

/// The inverse bind matrix of a joint that stood at `p`.
fn bound_at(p: [f64; 3]) -> [f64; 16] {
    let mut matrix = ONE;
    matrix[12..15].copy_from_slice(&p.map(|x| -x));
    matrix
}

/// Three corners, bound to `joints` with `weights`, and a document in which node 0 has them and is moved far away.
struct Skinned {
    buffer: Buffer,
    attributes: Value,
}

impl Skinned {
    fn new(joints: &[[f64; 4]; 3], weights: &[[f64; 4]; 3]) -> Self {
        let mut buffer = Buffer::default();
        buffer.vectors(F32, &CORNERS[..3]);
        buffer.vectors(U8, joints);
        buffer.vectors(F32, weights);
        let attributes = json!({"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2});
        Self { buffer, attributes }
    }

    /// Nodes 1 … and the skin's joints among them.
    fn document(&self, nodes: &Value, joints: &Value) -> Value {
        let mut document = one(&self.buffer, json!({"attributes": self.attributes}));
        document["nodes"] = json!([{"mesh": 0, "skin": 0, "translation": [90, 90, 90]}]);
        let all = document["nodes"].as_array_mut().expect("an array");
        all.extend(nodes.as_array().expect("nodes").iter().cloned());
        document["skins"] = json!([{"joints": joints}]);
        document
    }

    fn positions(&self, document: &Value) -> Vec<DVec3> {
        let mesh = read(document, &self.buffer.bytes).expect("a mesh");
        assert!(mesh.warnings.is_empty(), "{:?}", mesh.warnings);
        mesh.positions
    }
}

const FIRST: [[f64; 4]; 3] = [[1., 0., 0., 0.]; 3];

/// A root that turns z to y above mesh and joint, as exporters write it: (x, y, z) becomes (x, z, −y). The joint was at (0, 0,
/// 1) when it was bound and is there still.
#[test]
fn a_mesh_follows_its_joints_and_not_its_node() {
    let skinned = Skinned::new(&[[0.; 4]; 3], &FIRST);
    let root = json!({"children": [0, 2], "matrix": [1,0,0,0, 0,0,-1,0, 0,1,0,0, 0,0,0,1]});
    let nodes = json!([root, {"name": "joint", "translation": [0, 0, 1]}]);
    let mut document = skinned.document(&nodes, &json!([2]));
    document["scenes"][0]["nodes"] = json!([1]);
    let mut expected = vectors(&CORNERS[..3]).into_iter();
    let upright = |p: DVec3| DVec3::new(p.x, p.z + 1.0, -p.y);
    let moved: Vec<_> = expected.clone().map(upright).collect();
    assert_eq!(skinned.positions(&document), moved);
    // With the matrix that undoes where the joint was.
    let mut skinned = skinned;
    let matrices = skinned.buffer.vectors(F32, &[bound_at([0., 0., 1.])]);
    let mut document = skinned.document(&nodes, &json!([2]));
    document["skins"][0]["inverseBindMatrices"] = json!(matrices);
    document["scenes"][0]["nodes"] = json!([1]);
    let positions = skinned.positions(&document);
    let bound = |p: DVec3| expected.next().map(|e| upright(e) - DVec3::Y) == Some(p);
    assert!(positions.into_iter().all(bound));
}

/// Joints at (10, 0, 0) and (0, 20, 0), the second twice as large, with weights 1 : 4: p' = 0.2(p + 10x) + 0.8(2p + 20y), in
/// every notation of the weights, and wherever the joints are.
#[test]
fn weights_of_every_type_blend() {
    let nodes = json!([
        {"translation": [4, 0, 0], "children": [2]}, {"translation": [6, 0, 0]},
        {"translation": [0, 20, 0], "scale": [2, 2, 2]},
    ]);
    let expected = vectors(&CORNERS[..3]);
    let expected = expected
        .iter()
        .map(|p| 1.8 * *p + DVec3::new(2.0, 16.0, 0.0));
    let expected: Vec<_> = expected.collect();
    let joints = [[0., 1., 0., 0.], [7., 1., 9., 0.], [1., 0., 7., 7.]];
    let with = |kind: u32, a: f64, b: f64, normalized: bool, joints_as: u32| {
        let weights = [[a, b, 0., 0.], [0., b, 0., a], [b, a, 0., 0.]];
        let mut skinned = Skinned::new(&joints, &FIRST);
        let written = skinned.buffer.vectors(kind, &weights);
        skinned.buffer.accessors[written]["normalized"] = json!(normalized);
        let joints = skinned.buffer.vectors(joints_as, &joints);
        skinned.attributes["WEIGHTS_0"] = json!(written);
        skinned.attributes["JOINTS_0"] = json!(joints);
        let document = skinned.document(&nodes, &json!([2, 3]));
        for (p, e) in skinned.positions(&document).iter().zip(&expected) {
            assert!(p.distance(*e) < 1e-13, "{kind} {normalized}: {p} {e}");
        }
    };
    with(F32, 1.0, 4.0, false, U8);
    with(U8, 51.0, 204.0, true, U16);
    with(U8, 51.0, 204.0, false, U8);
    with(U16, 13107.0, 52428.0, true, U16);
    with(U16, 13107.0, 52428.0, false, U8);
}

/// Five joints move each vertex by powers of two; all weights are 1/5 or, of the last, 0: it follows its first joint.
#[test]
fn sets_go_on_and_a_vertex_without_weights_follows_its_first_joint() {
    let mut skinned = Skinned::new(
        &[[0., 1., 2., 3.], [0., 1., 2., 3.], [3., 1., 9., 9.]],
        &[[1.; 4], [1.; 4], [0.; 4]],
    );
    let joints = skinned.buffer.vectors(U8, &[[4., 9., 9., 9.]; 3]);
    let weights = [[1., 0., 0., 0.], [1., 0., 0., 0.], [0.; 4]];
    let weights = skinned.buffer.vectors(F32, &weights);
    skinned.attributes["JOINTS_1"] = json!(joints);
    skinned.attributes["WEIGHTS_1"] = json!(weights);
    let nodes = [10, 20, 40, 80, 160].map(|x| json!({"translation": [x, 0, 0]}));
    let document = skinned.document(&json!(nodes), &json!([1, 2, 3, 4, 5]));
    let moved = [62.0, 62.0, 80.0].map(|x| DVec3::X * x);
    for ((p, c), by) in skinned.positions(&document).iter().zip(CORNERS).zip(moved) {
        assert!(p.distance(DVec3::from(c) + by) < 1e-13, "{p} {by}");
    }
}

/// The normals of the ellipsoid that joints make of a unit sphere: (x/a², y/b², z/c²), and the triangle's own normal keeps
/// to their side where the blended matrix mirrors.
#[test]
fn normals_stay_outward() {
    let points = [[1., 2., 2.], [2., 1., 2.], [2., 2., 1.]].map(|p| p.map(|x: f64| x / 3.0));
    let mut skinned = Skinned::new(&[[0., 1., 0., 0.]; 3], &[[1., 1., 0., 0.]; 3]);
    let sphere = skinned.buffer.vectors(F32, &points);
    skinned.attributes["POSITION"] = json!(sphere);
    skinned.attributes["NORMAL"] = json!(sphere);
    for scale in [[1., 1., 1.], [3., 0.5, 1.], [-1., 1., 1.], [-3., -2., -1.]] {
        // Two joints whose mean it is.
        let [a, b, c] = scale;
        let joints = json!([{"scale": [a + 1.0, b, c - 0.5]}, {"scale": [a - 1.0, b, c + 0.5]}]);
        let document = skinned.document(&joints, &json!([1, 2]));
        let mesh = read(&document, &skinned.buffer.bytes).expect("a mesh");
        let normals = mesh.normals.expect("normals");
        for (p, n) in mesh.positions.iter().zip(&normals) {
            let expected = (*p / DVec3::from(scale) / DVec3::from(scale)).normalize();
            assert!(n.distance(expected) < 1e-6, "{scale:?}: {n} {expected}");
        }
        let [a, b, c] = mesh.triangles[0].map(|i| mesh.positions[i as usize]);
        assert!((b - a).cross(c - a).dot(a) > 0.0, "{scale:?}");
    }
}

/// A chain of 20,000 joints, each 0.5 along x from the one before; the mesh is bound to the last of them, and the scene
/// has none.
#[test]
fn chains_of_joints_may_be_long() {
    let skinned = Skinned::new(&[[1., 0., 0., 0.]; 3], &FIRST);
    let length = 20_000;
    let joint = |i: usize| json!({"translation": [0.5, 0, 0], "children": [i + 1]});
    let mut nodes: Vec<_> = (1..=length).map(joint).collect();
    nodes[length - 1]["children"] = json!([]);
    let document = skinned.document(&json!(nodes), &json!([1, length]));
    let moved = vectors(&CORNERS[..3])
        .into_iter()
        .map(|p| p + DVec3::X * 1e4);
    assert_eq!(skinned.positions(&document), moved.collect::<Vec<_>>());
    nodes[length - 1]["children"] = json!([1]);
    let document = skinned.document(&json!(nodes), &json!([1, length]));
    let words = read(&document, &skinned.buffer.bytes).expect_err("a circle");
    assert_eq!(words.to_string(), "skin 0: node 20000 is its own ancestor");
}

#[test]
fn damaged_skins_never_panic() {
    let mut skinned = Skinned::new(&[[0., 1., 0., 0.]; 3], &[[0.25, 0.75, 0., 0.]; 3]);
    let matrices = skinned.buffer.vectors(F32, &[ONE, bound_at([1., 2., 3.])]);
    let mut document = skinned.document(&json!([{"children": [2]}, {}]), &json!([1, 2]));
    document["skins"][0]["inverseBindMatrices"] = json!(matrices);
    never_panics(&document, &skinned.buffer.bytes);
}

/// A pointer into the document, the value put there, and the message.
const FAULTS: [(&str, &str, &str); 13] = [
    ("/nodes/0/skin", "7", "skin 7 does not exist"),
    (
        "/skins/0/joints",
        "[1, 9]",
        "skin 0 (\"Rig\"): node 9 does not exist",
    ),
    (
        "/skins/0/joints",
        "[1, 1, 1]",
        "skin 0 (\"Rig\"): it has 2 inverse bind matrices for 3 joints",
    ),
    (
        "/skins/0/joints",
        "[1]",
        "mesh 0, primitive 0: its vertex 1 is bound to joint 1, but skin 0 (\"Rig\") has 1",
    ),
    (
        "/skins/0/joints",
        "[]",
        "mesh 0, primitive 0: its vertex 0 is bound to joint 0, but skin 0 (\"Rig\") has 0",
    ),
    (
        "/skins/0/inverseBindMatrices",
        "2",
        "skin 0 (\"Rig\"): accessor 2: its elements are not MAT4",
    ),
    (
        "/skins/0/inverseBindMatrices",
        "4",
        "skin 0 (\"Rig\"): its inverse bind matrix 1 is not finite",
    ),
    (
        "/nodes/1/rotation",
        "[0, 0, 0, 0]",
        "skin 0 (\"Rig\"): the rotation of node 1 is zero",
    ),
    (
        "/meshes/0/primitives/0/attributes",
        "{\"POSITION\": 0}",
        "mesh 0, primitive 0: skin 0 (\"Rig\") moves it, but it has no JOINTS_0",
    ),
    (
        "/meshes/0/primitives/0/attributes",
        "{\"POSITION\": 0, \"JOINTS_0\": 1}",
        "mesh 0, primitive 0: skin 0 (\"Rig\") moves it, but it has no WEIGHTS_0",
    ),
    (
        "/meshes/0/primitives/0/attributes/JOINTS_1",
        "1",
        "mesh 0, primitive 0: skin 0 (\"Rig\") moves it, but it has no WEIGHTS_1",
    ),
    (
        "/meshes/0/primitives/0/attributes/WEIGHTS_0",
        "5",
        "mesh 0, primitive 0: its vertex 2 has the weight -0.5",
    ),
    (
        "/accessors/2/count",
        "2",
        "mesh 0, primitive 0: it has weights for 2 vertices, but there are 3",
    ),
];

#[test]
fn mistakes_of_a_skin_are_named() {
    let joints = [[0., 9., 9., 9.], [1., 0., 0., 0.], [0.; 4]];
    let mut skinned = Skinned::new(&joints, &FIRST);
    let buffer = &mut skinned.buffer;
    buffer.vectors(F32, &[ONE; 2]);
    buffer.vectors(F32, &[ONE, [f64::NAN; 16]]);
    buffer.vectors(F32, &[FIRST[0], FIRST[0], [1., -0.5, 0., 0.]]);
    let mut document = skinned.document(&json!([{}, {}]), &json!([1, 2]));
    document["skins"][0]["inverseBindMatrices"] = json!(3);
    document["skins"][0]["name"] = json!("Rig");
    skinned.positions(&document);
    for (pointer, value, message) in FAULTS {
        let mut document = document.clone();
        let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
        let value: Value = serde_json::from_str(value).expect(value);
        document.pointer_mut(parent).expect(parent)[name] = value;
        let words = read(&document, &skinned.buffer.bytes).expect_err(pointer);
        assert_eq!(words.to_string(), message, "{pointer}");
    }
}
