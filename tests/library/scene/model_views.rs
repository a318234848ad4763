//! Cameras of glTF files.

use std::path::Path;

use glam::{DQuat, DVec3};
use serde_json::{Value, json};
use vkpt::scene::{Camera, Read, Screen, parse_model};

use crate::common::models::{Model, lamp};

fn read(model: &Model, camera: Option<&str>) -> Result<Read, String> {
    let read = parse_model(&model.glb(), Path::new("m.glb"), false, camera);
    read.map_err(|errors| errors.diagnostics[0].to_string())
}

fn block() -> Model {
    let mut model = Model::unseen();
    model.cuboid([-1.0; 3], [1.0; 3], lamp(1.0));
    model
}

/// [`block`] seen by cameras at nodes.
fn seen(cameras: Value, nodes: &[Value]) -> Model {
    let mut model = block();
    model.document["cameras"] = cameras;
    for node in nodes {
        model.add_node(node.clone());
    }
    model
}

fn perspective(yfov: f64, aspect: f64) -> Value {
    json!({"type": "perspective", "perspective": {"yfov": yfov, "aspectRatio": aspect, "znear": 1}})
}

fn directions(camera: &Camera) -> [DVec3; 3] {
    [DVec3::X, DVec3::Y, DVec3::NEG_Z].map(|v| camera.orientation * v)
}

/// Numbers of the format are single: results computed from them are as close as that.
fn near(a: DVec3, b: DVec3) {
    assert!((a - b).length() < 1e-7 * (1.0 + b.length()), "{a} and {b}");
}

#[test]
fn field_of_view_and_size_are_the_cameras() {
    for (yfov, aspect, height) in [(1.0, 2.0, 200), (0.5, 4.0 / 3.0, 300), (2.0, 0.5, 800)] {
        let model = seen(json!([perspective(yfov, aspect)]), &[json!({"camera": 0})]);
        let scene = read(&model, None).expect("a scene").scene;
        assert_eq!(scene.screen, Screen { width: 400, height });
        assert_eq!(scene.camera.ry, (yfov / 2.0).tan());
        assert_eq!(
            (scene.camera.eye, scene.camera.orientation),
            (DVec3::ZERO, DQuat::IDENTITY)
        );
    }
    let none = json!([{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}]);
    let scene = read(&seen(none, &[json!({"camera": 0})]), None)
        .expect("a scene")
        .scene;
    assert_eq!(
        scene.screen,
        Screen {
            width: 400,
            height: 300
        }
    );
}

/// A quarter turn about Y looks along −X; the nodes above it move, turn and scale it.
#[test]
fn nodes_place_and_turn_it_and_their_scales_do_not_count() {
    let half = 0.5f64.sqrt();
    let turned = json!({"camera": 0, "translation": [1, 2, 3], "rotation": [0, half, 0, half]});
    let mut model = seen(json!([perspective(1.0, 1.0)]), &[]);
    let child = model.document["nodes"].as_array().expect("nodes").len();
    let above = json!({"translation": [10, 0, 0], "scale": [2, 2, 2], "children": [child]});
    let nodes = model.document["nodes"].as_array_mut().expect("nodes");
    nodes.push(turned);
    model.add_node(above);
    let camera = read(&model, None).expect("a scene").scene.camera;
    near(camera.eye, DVec3::new(12.0, 4.0, 6.0));
    let [right, up, forward] = directions(&camera);
    near(right, DVec3::NEG_Z);
    near(up, DVec3::Y);
    near(forward, DVec3::NEG_X);
}

#[test]
fn a_camera_is_found_by_its_nodes_name_its_own_or_its_number() {
    let mut named = perspective(1.0, 1.0);
    named["name"] = json!("Lens");
    let cameras = json!([perspective(0.5, 1.0), named]);
    let nodes = [
        json!({"camera": 0, "translation": [0, 0, 1]}),
        json!({"camera": 1, "translation": [0, 0, 2], "name": "Front"}),
        json!({"camera": 1, "translation": [0, 0, 3]}),
    ];
    let model = seen(cameras, &nodes);
    let z = |name| read(&model, name).map(|read| read.scene.camera.eye.z);
    assert_eq!(z(None), Ok(1.0));
    assert_eq!(z(Some("Front")), Ok(2.0));
    assert_eq!(z(Some("Lens")), Ok(2.0));
    assert_eq!(z(Some("0")), Ok(1.0));
    let unknown = "m.glb: camera `Back` does not exist; its cameras are `0`, `Front`, `Lens`";
    assert_eq!(z(Some("Back")), Err(unknown.to_owned()));
    let none = read(&block(), Some("Back")).expect_err("no camera");
    assert_eq!(
        none,
        "m.glb: camera `Back` does not exist: its scene has no cameras"
    );
}

#[test]
fn cameras_that_are_none_are_refused_by_name() {
    let orthographic = json!({"type": "orthographic", "name": "Plan",
        "orthographic": {"xmag": 1, "ymag": 1, "zfar": 2, "znear": 1}});
    let cases = [
        (
            orthographic,
            json!({}),
            "camera 0 (\"Plan\"): it is not perspective: use a perspective camera",
        ),
        (
            perspective(4.0, 1.0),
            json!({}),
            "camera 0: its yfov must be below π",
        ),
        (
            perspective(0.0, 1.0),
            json!({}),
            "camera 0: its yfov must be above 0",
        ),
        (
            perspective(1.0, -1.0),
            json!({}),
            "camera 0: its aspectRatio must be above 0",
        ),
        (
            perspective(1.0, 1.0),
            json!({"scale": [1, 1, 0]}),
            "camera 0: the scale of node 1 leaves it no direction",
        ),
    ];
    for (camera, mut node, message) in cases {
        node["camera"] = json!(0);
        let error = read(&seen(json!([camera]), &[node]), None).expect_err(message);
        assert!(error.starts_with(&format!("m.glb: {message}")), "{error}");
    }
    let error = read(&seen(json!([]), &[json!({"camera": 7})]), None).expect_err("no camera");
    assert_eq!(error, "m.glb: node 1: camera 7 does not exist");
}

/// All corners are in the picture, and fill more than half its height.
#[test]
fn without_a_camera_all_is_seen() {
    for (lo, hi) in [
        ([-1.0; 3], [1.0; 3]),
        ([5.0, 0.0, 0.0], [6.0, 30.0, 1.0]),
        ([1e4; 3], [3e4; 3]),
    ] {
        let mut model = Model::unseen();
        model.cuboid(lo, hi, lamp(1.0));
        let read = read(&model, None).expect("a scene");
        let words = read.warnings[0].to_string();
        assert!(
            words.contains("it has no camera: the view is from the front"),
            "{words}"
        );
        let Camera { eye, ry, .. } = read.scene.camera;
        let [right, up, forward] = directions(&read.scene.camera);
        assert!(
            forward.z < 0.0 && forward.y < 0.0 && forward.x < 0.0,
            "{forward}"
        );
        let mut highest = 0.0f64;
        for i in 0..8 {
            let corner = DVec3::from([0, 1, 2].map(|k| [lo, hi][i >> k & 1][k])) - eye;
            let depth = corner.dot(forward);
            let (x, y) = (corner.dot(right) / depth, corner.dot(up) / depth);
            assert!(depth > 0.0 && x.abs() < ry * 4.0 / 3.0 && y.abs() < ry);
            highest = highest.max(y.abs() / ry);
        }
        assert!(highest > 0.5, "{highest}");
    }
}
