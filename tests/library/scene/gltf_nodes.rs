//! Nodes and scenes of glTF files: which are read, and where they are placed.

use glam::{DQuat, DVec3};
use serde_json::{Value, json};

use super::gltf::{CORNERS, SQUARE, add, one, plain, read, vectors};
use crate::common::gltf_writer::{Buffer, F32};

/// p' = T·R·S·p of each node below the other, against quaternions and vectors by hand.
#[test]
fn nodes_are_placed_and_a_mesh_may_stand_in_several() {
    let (mut document, bin) = plain();
    document["nodes"] = json!([
        {"children": [1, 2], "translation": [1, 2, 3], "rotation": [0, 0, 3, 4]},
        {"mesh": 0, "scale": [2, 3, 4]},
        {"mesh": 0, "matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]},
        {"mesh": 0},
    ]);
    let mesh = read(&document, &bin).expect("a mesh");
    let turn = DQuat::from_xyzw(0.0, 0.0, 0.6, 0.8);
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

/// The normals of the ellipsoid that a scaled unit sphere is: (x/a², y/b², z/c²), which points out for any signs
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
    // Node 2 keeps its place below node 1.
    assert_eq!(first(scenes.clone(), json!(2)), [0.0, 2.0]);
    assert_eq!(first(scenes, Value::Null), [0.0]);
    assert_eq!(first(json!([]), Value::Null), [0.0, 1.0, 2.0]);
}

/// Objects at x = 1 and 2, and points at 9.
#[test]
fn a_scene_without_triangles_gives_way_to_one_that_has_some() {
    let (mut document, bin) = plain();
    let points = json!({"attributes": {"POSITION": 0}, "mode": 0});
    add(&mut document, "meshes", json!({"primitives": [points]}));
    let node = |mesh: usize, x: usize| json!({"mesh": mesh, "translation": [x, 0, 0]});
    document["nodes"] = json!([node(0, 1), node(0, 2), node(1, 9), {"name": "light"}]);
    let mut first = |scenes: Value, scene: Value| {
        (document["scenes"], document["scene"]) = (scenes, scene);
        let mesh = read(&document, &bin).expect("a mesh");
        (mesh.positions[0].x, mesh.warnings.join("; "))
    };
    let rows = [
        (json!([{"nodes": [0]}, {}]), json!(0), 1.0, ""),
        (json!([{}, {"nodes": [1]}]), json!(1), 2.0, ""),
        (
            json!([{}, {"nodes": [1]}]),
            json!(0),
            2.0,
            "scene 0 has no triangles: scene 1 is read instead",
        ),
        (
            json!([{"nodes": []}, {"nodes": [3]}, {"nodes": [1]}]),
            Value::Null,
            2.0,
            "scene 0 has no triangles: scene 2 is read instead",
        ),
        (
            json!([{"nodes": [0], "name": "Set"}, {"nodes": [2], "name": "Points"}]),
            json!(1),
            1.0,
            "scene 1 (\"Points\") has no triangles: scene 0 (\"Set\") is read instead",
        ),
    ];
    for (scenes, scene, x, warning) in rows {
        let found = first(scenes.clone(), scene);
        assert_eq!(found, (x, warning.to_owned()), "{scenes}");
    }
    for scenes in [json!([{}]), json!([{}, {"nodes": [2]}])] {
        document["scenes"] = scenes;
        document["scene"] = json!(0);
        let message = read(&document, &bin).expect_err("no triangles");
        assert_eq!(message.to_string(), "it has no triangles");
    }
}

/// None of this is inspected, so it may have any form.
#[test]
fn unused_nodes_may_be_invalid() {
    let (mut document, bin) = plain();
    let expected = read(&document, &bin).expect("a mesh");
    document["animations"] = json!([{"channels": [{"sampler": 0, "target": {"path": "pointer"}}]}]);
    for name in [
        "materials",
        "textures",
        "images",
        "samplers",
        "cameras",
        "extensions",
        "extras",
        "skins_",
        "extensionsUsed",
    ] {
        document[name] = json!([7, "x", {"nodes": -1}, null]);
    }
    for pointer in [
        "/nodes/0",
        "/meshes/0",
        "/scenes/0",
        "/accessors/0",
        "/buffers/0",
    ] {
        let object = document.pointer_mut(pointer).expect(pointer);
        object["extras"] = json!([1e300, -1]);
        object["camera"] = json!("none");
        object["weights"] = json!({});
        object["min"] = json!([null]);
    }
    document["meshes"][0]["primitives"][0]["material"] = json!(-1);
    assert_eq!(read(&document, &bin).expect("a mesh"), expected);
}

/// The errors of a node, by its number and name; nodes that are not read may be wrong.
#[test]
fn transforms_that_place_nothing_are_refused_by_node() {
    let rows = [
        (json!({"rotation": [0, 0, 0, 0]}), "rotation", "is zero"),
        (
            json!({"rotation": [0, 0, 1e-200, 0]}),
            "rotation",
            "is zero",
        ),
        (
            json!({"rotation": [0, 0, 1e39, 0]}),
            "rotation",
            "is not finite in single precision",
        ),
        (
            json!({"scale": [1, 1, -4e38]}),
            "scale",
            "is not finite in single precision",
        ),
        (
            json!({"translation": [4e38, 0, 0]}),
            "translation",
            "is not finite in single precision",
        ),
        (
            json!({"matrix": [1,0,0,0, 0,1,0,0, 0,0,1e300,0, 0,0,0,1]}),
            "matrix",
            "is not finite in single precision",
        ),
        (
            json!({"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]}),
            "matrix",
            "has a last row other than 0 0 0 1",
        ),
    ];
    let (mut document, bin) = plain();
    for (mut node, what, is) in rows {
        node["name"] = json!("Arm");
        node["children"] = json!([0]);
        document["nodes"] = json!([{"mesh": 0}, {}, {}, node]);
        document["scenes"][0]["nodes"] = json!([3]);
        let message = read(&document, &bin).expect_err(what).to_string();
        assert_eq!(message, format!("the {what} of node 3 (\"Arm\") {is}"));
        document["nodes"][3]["children"] = json!([]);
        document["scenes"][0]["nodes"] = json!([0, 3]);
        let mesh = read(&document, &bin).expect("a mesh");
        assert_eq!(mesh.positions, vectors(&CORNERS));
    }
    let huge = (0..9).map(|i| json!({"children": [i + 1], "scale": [1e38, 1e38, 1e38]}));
    document["nodes"] = huge.chain([json!({"mesh": 0})]).collect();
    document["scenes"][0]["nodes"] = json!([0]);
    let message = read(&document, &bin).expect_err("beyond all numbers");
    assert_eq!(
        message.to_string(),
        "the transform of node 8 to its scene is not finite"
    );
}

/// (x, y, z) becomes (x, 0, 4z): its normals lie along y, where they had any of that.
#[test]
fn a_scale_of_zero_flattens() {
    let mut buffer = Buffer::default();
    buffer.vectors(F32, &[[1., 2., 3.], [4., 5., 6.], [7., 8., 1.]]);
    buffer.vectors(F32, &[[0., 1., 0.], [3., -4., 0.], [0., 0., 1.]]);
    let attributes = json!({"POSITION": 0, "NORMAL": 1});
    let mut document = one(&buffer, json!({"attributes": attributes}));
    document["nodes"][0]["scale"] = json!([1, 0, 4]);
    let mesh = read(&document, &buffer.bytes).expect("a mesh");
    assert_eq!(
        mesh.positions,
        vectors(&[[1., 0., 12.], [4., 0., 24.], [7., 0., 4.]])
    );
    assert_eq!(
        mesh.normals.expect("normals"),
        [DVec3::Y, DVec3::NEG_Y, DVec3::ZERO]
    );
    assert!(mesh.warnings.is_empty());
}

#[test]
fn meshes_scaled_to_nothing_are_left_out() {
    let (mut document, bin) = plain();
    document["scenes"][0]["nodes"] = json!([0, 2, 3]);
    document["nodes"] = json!([
        {"children": [1], "scale": [0, 1, 0], "name": "Hidden"}, {"mesh": 0, "scale": [2, 2, 2]},
        {"mesh": 0, "matrix": [0,0,0,0, 0,0,0,0, 0,0,0,0, 5,5,5,1]}, {"mesh": 0},
    ]);
    let mesh = read(&document, &bin).expect("a mesh");
    assert_eq!(mesh.triangles, SQUARE);
    let hidden = "the scale of node 0 (\"Hidden\") is zero: its mesh";
    assert_eq!(
        mesh.warnings,
        [format!("{hidden} and 1 more like it are skipped")]
    );
    document["scenes"][0]["nodes"] = json!([0]);
    let message = read(&document, &bin).expect_err("nothing").to_string();
    assert_eq!(message, format!("it has no triangles: {hidden} is skipped"));
}

/// Each instance would be its own mesh.
#[test]
fn instances_are_missed_with_a_warning() {
    let (mut document, bin) = plain();
    document["extensionsUsed"] = json!(["EXT_mesh_gpu_instancing"]);
    document["nodes"][0]["extensions"] =
        json!({"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}});
    let mesh = read(&document, &bin).expect("a mesh");
    let message = "only the first instance (EXT_mesh_gpu_instancing) is read, at its node";
    assert_eq!(mesh.warnings, [message]);
}
