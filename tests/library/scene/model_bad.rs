//! glTF files that are no scene.

use std::path::Path;

use serde_json::{Value, json};
use vkpt::scene::{parse_model, read, read_seen};

use crate::bodies;
use crate::common::gltf_writer::glb;
use crate::common::models::{Model, glass, lamp, matte};

/// Its errors.
fn errors(model: &Model) -> Vec<String> {
    let read = parse_model(&model.glb(), Path::new("m.glb"), false, None);
    let errors = read.expect_err("errors").diagnostics;
    errors.iter().map(ToString::to_string).collect()
}

fn block(material: Value) -> Model {
    let mut model = Model::seen_from([0.0, 0.0, 5.0], 0.5);
    model.cuboid([-1.0; 3], [1.0; 3], material);
    model
}

#[test]
fn numbers_that_are_not_legal_are_refused_by_name() {
    let specular = |value: Value| json!({"KHR_materials_specular": value});
    let cases = [
        (
            json!({"pbrMetallicRoughness": {"roughnessFactor": -1}}),
            "its roughnessFactor must not be negative",
        ),
        (
            json!({"pbrMetallicRoughness": {"baseColorFactor": [1, -1, 0, 1]}}),
            "its baseColorFactor must not be negative",
        ),
        (
            json!({"emissiveFactor": [0, 0, -1]}),
            "its emissiveFactor must not be negative",
        ),
        (
            json!({"emissiveFactor": [1e39, 0, 0]}),
            "its emissiveFactor is not finite in single precision",
        ),
        (
            json!({"extensions": {"KHR_materials_ior": {"ior": -1}}}),
            "its ior must be above 0",
        ),
        (
            json!({"extensions": specular(json!({"specularFactor": -1}))}),
            "its specularFactor must not be negative",
        ),
        (
            json!({"extensions": {"KHR_materials_volume": {"attenuationDistance": 0}}}),
            "its attenuationDistance must be above 0",
        ),
        (
            json!({"emissiveFactor": [1e30, 0, 0],
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 1e30}}}),
            "its emission is not finite in single precision",
        ),
    ];
    for (material, message) in cases {
        assert_eq!(
            errors(&block(material)),
            [format!("m.glb: material 0: {message}")]
        );
    }
}

#[test]
fn a_share_above_1_counts_as_1() {
    let bright = json!({"pbrMetallicRoughness": {"baseColorFactor": [2, 1, 1, 1]}});
    let read = parse_model(&block(bright).glb(), Path::new("m.glb"), false, None).expect("a scene");
    let printed = read.warnings.iter().map(ToString::to_string);
    let expected = "m.glb: material 0: its baseColorFactor is above 1: taken as 1";
    assert!(printed.collect::<Vec<_>>().contains(&expected.to_owned()));
}

#[test]
fn all_mistakes_are_printed_at_once() {
    let mut model = block(json!({"emissiveFactor": [-1, 0, 0]}));
    model.document["cameras"][0]["perspective"]["yfov"] = json!(7);
    model.cuboid(
        [3.0; 3],
        [4.0; 3],
        json!({"extensions": {"KHR_materials_ior": {"ior": -1}}}),
    );
    model.light([0.0; 3], json!({"type": "point", "intensity": -1}));
    let expected = [
        "m.glb: camera 0: its yfov must be below π",
        "m.glb: material 0: its emissiveFactor must not be negative",
        "m.glb: material 1: its ior must be above 0",
        "m.glb: light 0: its intensity must not be negative",
    ];
    assert_eq!(errors(&model), expected);
}

#[test]
fn missing_materials_lights_and_triangles_are_named() {
    let mut model = block(lamp(1.0));
    model.document["meshes"][0]["primitives"][0]["material"] = json!(9);
    assert_eq!(errors(&model), ["m.glb: material 9: it does not exist"]);
    let mut model = block(lamp(1.0));
    model.add_node(json!({"extensions": {"KHR_lights_punctual": {"light": 3}}}));
    assert_eq!(errors(&model), ["m.glb: node 2: light 3 does not exist"]);
    let model = Model::seen_from([0.0; 3], 1.0);
    assert_eq!(errors(&model), ["m.glb: it has no triangles"]);
}

#[test]
fn json_of_another_kind_is_refused() {
    for (place, value) in [
        (
            "materials",
            json!([{"pbrMetallicRoughness": {"metallicFactor": "much"}}]),
        ),
        ("cameras", json!(3)),
        (
            "extensions",
            json!({"KHR_lights_punctual": {"lights": [{}]}}),
        ),
    ] {
        let mut model = block(lamp(1.0));
        model.document[place] = value;
        let errors = errors(&model);
        let [error] = &errors[..] else {
            panic!("{errors:?}")
        };
        assert!(
            error.starts_with("m.glb: cannot read its JSON: "),
            "{error}"
        );
    }
}

/// A file cut short anywhere, and files that are none.
#[test]
fn broken_files_are_refused_whole() {
    let whole = block(matte([0.5; 3])).glb();
    for length in 0..whole.len() {
        let read = parse_model(&whole[..length], Path::new("m.glb"), false, None);
        let errors = read.expect_err("a part of a file").diagnostics;
        assert_eq!(errors.len(), 1, "{length}");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("m.glb");
    std::fs::write(&path, "screen 4 3\ncamera 0 0 5 1\n").expect("a file");
    let error = read(&path, false).expect_err("no glTF").diagnostics[0].to_string();
    assert!(error.contains("cannot read its JSON"), "{error}");
    let error = read(&folder.path().join("none.gltf"), false).expect_err("no file");
    assert!(error.diagnostics[0].to_string().contains("cannot read"));
}

/// By its bytes a GLB is known under any name; a scene file has no camera to choose.
#[test]
fn a_scene_file_has_no_cameras_by_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.scn");
    std::fs::write(&path, block(lamp(1.0)).glb()).expect("a file");
    assert!(read_seen(&path, false, Some("Eye")).is_ok());
    std::fs::write(&path, "screen 4 3\ncamera 0 0 5 1\n").expect("a file");
    let error = read_seen(&path, false, Some("Eye")).expect_err("a scene file");
    assert!(
        error.diagnostics[0]
            .to_string()
            .contains("is not a glTF file")
    );
}

/// The places of all values in a document.
fn places(value: &Value, place: &str, all: &mut Vec<String>) {
    all.push(place.to_owned());
    match value {
        Value::Object(of) => of
            .iter()
            .for_each(|(name, value)| places(value, &format!("{place}/{name}"), all)),
        Value::Array(of) => (of.iter().enumerate())
            .for_each(|(i, value)| places(value, &format!("{place}/{i}"), all)),
        _ => {}
    }
}

/// With any value replaced by any other, the file is read as a scene that keeps its promises, or refused.
#[test]
fn any_value_may_stand_anywhere() {
    let mut model = block(glass([0.9, 0.5, 0.1], 2.0));
    model.cuboid([3.0; 3], [4.0; 3], matte([0.5; 3]));
    model.cuboid([5.0; 3], [6.0; 3], lamp(1.0));
    let light = json!({"type": "point", "intensity": 2, "color": [1, 1, 1], "name": "L"});
    model.light([9.0; 3], light);
    let whole = model.whole(None);
    let mut all = Vec::new();
    places(&whole, "", &mut all);
    let nasty = [
        json!(null),
        json!(true),
        json!("\u{7}x"),
        json!([]),
        json!({}),
        json!(-1),
        json!(0),
        json!(2),
        json!(1e-46),
        json!(1e39),
        json!(u64::MAX),
        json!([1e38, 1e38, 1e38]),
    ];
    for place in &all {
        for value in &nasty {
            let mut document = whole.clone();
            *document.pointer_mut(place).expect("a value") = value.clone();
            println!("{place}: {value}");
            bodies::model(&glb(&document, model.bytes()));
        }
    }
}
