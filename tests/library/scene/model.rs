//! glTF files as scenes: a row of docs/gltf.md each.

use std::f64::consts::PI;
use std::path::Path;

use glam::DVec3;
use miette::Severity;
use serde_json::{Value, json};
use vkpt::scene::{Brdf, Geometry, MaterialKind, Read, parse_model};

use crate::common::models::{Model, glass, lamp, matte};

fn read(model: &Model) -> Read {
    let read = parse_model(&model.glb(), Path::new("m.glb"), false, None);
    read.unwrap_or_else(|errors| panic!("{:?}", errors.diagnostics))
}

/// The messages of a severity, without the file's name.
fn messages(read: &Read, severity: Severity) -> Vec<String> {
    let of = read.warnings.iter().filter(|d| d.severity == severity);
    of.map(|d| d.to_string().replace("m.glb: ", "")).collect()
}

/// A block of a material, and a lamp.
fn block(material: Value) -> Model {
    let mut model = Model::seen_from([0.0, 0.0, 5.0], 0.5);
    model.cuboid([-1.0; 3], [1.0; 3], material);
    model.cuboid([3.0; 3], [4.0; 3], lamp(2.0));
    model
}

/// The result of a material, and the warnings.
fn kind(material: Value) -> (MaterialKind, Vec<String>) {
    let read = read(&block(material));
    let warnings = messages(&read, Severity::Warning);
    (read.scene.materials[0].kind.clone(), warnings)
}

fn brdf(material: Value) -> (Brdf, Vec<String>) {
    match kind(material) {
        (MaterialKind::Brdf(brdf), warnings) => (brdf, warnings),
        (kind, _) => panic!("{kind:?}"),
    }
}

/// Sums and products of the table, with only their rounding.
fn near(a: DVec3, b: DVec3) {
    assert!((a - b).abs().max_element() < 1e-12, "{a} and {b}");
}

fn pbr(metallic: f64, roughness: f64, extensions: Value) -> Value {
    json!({
        "pbrMetallicRoughness":
            {"baseColorFactor": [0.8, 0.4, 0.2, 1], "metallicFactor": metallic, "roughnessFactor": roughness},
        "extensions": extensions,
    })
}

const BASE: DVec3 = DVec3::new(0.8, 0.4, 0.2);

#[test]
fn dielectrics_and_metals_are_opaque() {
    let cases = [
        // metallic, roughness, extensions, Kd, Ks, α
        (0.0, 1.0, json!({}), BASE, DVec3::splat(0.04), 1.0),
        (1.0, 0.5, json!({}), DVec3::ZERO, BASE, 0.25),
        (0.25, 0.0, json!({}), 0.75 * BASE, 0.25 * BASE + 0.03, 0.0),
        (
            0.0,
            0.2,
            json!({"KHR_materials_ior": {"ior": 3.0}}),
            BASE,
            DVec3::splat(0.25),
            0.04,
        ),
        (
            0.0,
            0.2,
            json!({"KHR_materials_ior": {"ior": 0}}),
            BASE,
            DVec3::ONE,
            0.04,
        ),
        (
            0.0,
            1.0,
            json!({"KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [2, 1, 50]}}),
            BASE,
            DVec3::new(0.04, 0.02, 0.5),
            1.0,
        ),
    ];
    for (metallic, roughness, extensions, kd, ks, alpha) in cases {
        let (brdf, warnings) = brdf(pbr(metallic, roughness, extensions.clone()));
        near(brdf.kd, kd);
        near(brdf.ks, ks);
        assert!((brdf.alpha - alpha).abs() < 1e-15, "{extensions}");
        assert_eq!((brdf.kt, warnings), (DVec3::ZERO, vec![]), "{extensions}");
    }
}

/// Kt over a length is attenuationColor over attenuationDistance.
#[test]
fn glass_of_a_thickness_absorbs_and_refracts() {
    let mut material = glass([0.9, 0.5, 0.1], 2.5);
    material["pbrMetallicRoughness"]["roughnessFactor"] = json!(0.5);
    material["extensions"]["KHR_materials_ior"] = json!({"ior": 3});
    let (brdf, warnings) = brdf(material);
    assert_eq!((brdf.kt, brdf.kt_length), (DVec3::new(0.9, 0.5, 0.1), 2.5));
    assert_eq!((brdf.kd, brdf.ior, brdf.alpha), (DVec3::ZERO, 3.0, 0.25));
    near(brdf.ks, DVec3::splat(0.25));
    assert_eq!(warnings, [""; 0]);
}

#[test]
fn thin_walls_and_partial_transmission_give_warnings() {
    let mut thin = glass([1.0; 3], 1.0);
    thin["extensions"]["KHR_materials_volume"]["thicknessFactor"] = json!(0);
    let (brdf, warnings) = brdf(thin);
    assert_eq!((brdf.kt, brdf.ior), (DVec3::ONE, 1.0));
    assert_eq!((brdf.kd, brdf.ks), (DVec3::ZERO, DVec3::ZERO));
    assert!(
        warnings[0].contains("material 0: it is thin-walled"),
        "{warnings:?}"
    );
    for (factor, metallic, passes, message) in [
        (
            0.75,
            0.0,
            true,
            "it transmits part of the light: taken as all",
        ),
        (
            0.25,
            0.0,
            false,
            "it transmits part of the light: taken as none",
        ),
        (
            1.0,
            0.75,
            false,
            "it transmits part of the light: taken as none",
        ),
    ] {
        let mut partly = glass([1.0; 3], 1.0);
        partly["pbrMetallicRoughness"]["metallicFactor"] = json!(metallic);
        partly["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = json!(factor);
        let (brdf, warnings) = self::brdf(partly);
        assert_eq!(brdf.kt != DVec3::ZERO, passes);
        assert_eq!(warnings, [format!("material 0: {message}")]);
    }
    let mut metal = glass([1.0; 3], 1.0);
    metal["pbrMetallicRoughness"]["metallicFactor"] = json!(1);
    assert_eq!(self::brdf(metal).0.kt, DVec3::ZERO);
}

#[test]
fn a_base_colour_does_not_tint_glass() {
    let mut tinted = glass([1.0; 3], 1.0);
    tinted["pbrMetallicRoughness"]["baseColorFactor"] = json!([1, 0.5, 0.5, 1]);
    let (brdf, warnings) = brdf(tinted);
    assert_eq!(brdf.kt, DVec3::ONE);
    let printed =
        "material 0: its base colour does not tint what it transmits: attenuationColor does";
    assert_eq!(warnings, [printed]);
}

#[test]
fn emissive_meshes_are_lights() {
    let mut shining = matte([0.0; 3]);
    shining["emissiveFactor"] = json!([1, 0.5, 0.25]);
    shining["extensions"]["KHR_materials_emissive_strength"] = json!({"emissiveStrength": 8});
    let radiance = MaterialKind::Light(DVec3::new(8.0, 4.0, 2.0));
    assert_eq!(kind(shining.clone()), (radiance.clone(), vec![]));
    shining["pbrMetallicRoughness"]["baseColorFactor"] = json!([1, 1, 1, 1]);
    let printed = "material 0: it emits light and reflects nothing: lights are black in vkpt";
    assert_eq!(kind(shining), (radiance, vec![printed.to_owned()]));
}

/// An emitting square has a rim; in glTF it emits to one side unless it is double-sided.
#[test]
fn an_open_light_shines_to_both_sides() {
    for both in [false, true] {
        let mut shining = lamp(1.0);
        shining["doubleSided"] = json!(both);
        let mut model = Model::seen_from([0.0, 0.0, 5.0], 0.5);
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        model.mesh(&corners, &[0, 1, 2], shining);
        let printed =
            "material 0: it is not closed, and emits light to both sides, as all lights in vkpt do";
        let expected = if both { vec![] } else { vec![printed] };
        assert_eq!(messages(&read(&model), Severity::Warning), expected);
    }
}

/// I = L π r²
#[test]
fn point_lights_are_balls_of_their_power() {
    let mut model = Model::seen_from([0.0, 0.0, 5.0], 0.5);
    model.cuboid([-1.0; 3], [1.0; 3], matte([0.5; 3]));
    model.light(
        [1.0, 2.0, 3.0],
        json!({"type": "point", "intensity": 10, "color": [1, 0.5, 0]}),
    );
    model.light([0.0, 9.0, 0.0], json!({"type": "point"}));
    let read = read(&model);
    let printed = "its point lights are balls of radius 1.73e-3 of the same power";
    assert_eq!(messages(&read, Severity::Advice), [printed]);
    let balls: Vec<_> = read.scene.shapes.iter().skip(1).collect();
    let expected = [
        (DVec3::new(1.0, 2.0, 3.0), DVec3::new(10.0, 5.0, 0.0)),
        (DVec3::new(0.0, 9.0, 0.0), DVec3::ONE),
    ];
    assert_eq!(balls.len(), expected.len());
    for (ball, (place, intensity)) in balls.into_iter().zip(expected) {
        let Geometry::Sphere { centre, radius } = ball.geometry else {
            panic!("{ball:?}")
        };
        let MaterialKind::Light(radiance) = read.scene.materials[ball.material].kind else {
            panic!("no light")
        };
        assert_eq!(centre, place);
        // A thousandth of half the diagonal of the scene.
        assert!((radius - 1e-3 * 3f64.sqrt()).abs() < 1e-15);
        near(radiance * PI * radius * radius, intensity);
    }
}

#[test]
fn other_lights_are_named() {
    let mut model = block(matte([0.5; 3]));
    model.light(
        [0.0; 3],
        json!({"type": "spot", "name": "Stage", "spot": {}}),
    );
    model.light([0.0; 3], json!({"type": "directional"}));
    let read = read(&model);
    assert_eq!(read.scene.shapes.len(), 2);
    let expected = [
        "light 0 (\"Stage\"): spot lights are not supported, so the picture lacks it: use an emissive mesh or a point light",
        "light 1: directional lights are not supported, so the picture lacks it: use an emissive mesh or a point light",
    ];
    assert_eq!(messages(&read, Severity::Warning), expected);
}

#[test]
fn without_a_light_all_around_is_white() {
    let mut model = Model::seen_from([0.0, 0.0, 5.0], 0.5);
    model.cuboid([-1.0; 3], [1.0; 3], matte([0.5; 3]));
    let dark = read(&model);
    assert_eq!(dark.scene.background, DVec3::ONE);
    let printed = "it has no lights: the background is white, with radiance 1";
    assert_eq!(messages(&dark, Severity::Advice), [printed]);
    let line = dark.text.lines().nth(dark.scene.background_line - 1);
    assert_eq!(line, Some("background 1 1 1  # the file has no lights"));
    let lit = read(&block(matte([0.5; 3])));
    assert_eq!(
        (lit.scene.background, lit.scene.background_line),
        (DVec3::ZERO, 0)
    );
    assert_eq!(messages(&lit, Severity::Advice), [""; 0]);
}

/// A node's transform places a primitive, and a mesh at two nodes is in the scene twice.
#[test]
fn a_primitive_of_a_node_is_a_shape() {
    let mut model = block(matte([0.5; 3]));
    model.add_node(json!({"mesh": 0, "translation": [10, 0, 0], "name": "Again"}));
    let read = read(&model);
    let meshes = read.scene.shapes.iter().map(|shape| match &shape.geometry {
        Geometry::Mesh(mesh) => (shape.material, mesh.positions[0], mesh.triangles.len()),
        other => panic!("{other:?}"),
    });
    let expected = [
        (0, DVec3::NEG_ONE, 12),
        (1, DVec3::splat(3.0), 12),
        (0, DVec3::new(9.0, -1.0, -1.0), 12),
    ];
    assert_eq!(meshes.collect::<Vec<_>>(), expected);
    let line = read.text.lines().nth(read.scene.shapes[2].line - 1);
    assert_eq!(
        line,
        Some("mesh node 3 (\"Again\"), mesh 0, primitive 0  # material 0")
    );
}

#[test]
fn unsupported_properties_are_named_once() {
    let mut material = matte([0.5; 3]);
    for texture in ["normalTexture", "occlusionTexture", "emissiveTexture"] {
        material[texture] = json!({"index": 0});
    }
    material["alphaMode"] = json!("BLEND");
    let pbr = &mut material["pbrMetallicRoughness"];
    pbr["baseColorTexture"] = json!({"index": 0});
    pbr["metallicRoughnessTexture"] = json!({"index": 0});
    let extensions = &mut material["extensions"];
    extensions["KHR_materials_specular"]["specularTexture"] = json!({"index": 0});
    for extension in ["clearcoat", "sheen", "anisotropy", "iridescence", "unlit"] {
        extensions[format!("KHR_materials_{extension}")] = json!({});
    }
    let mut model = block(material.clone());
    model.cuboid([7.0; 3], [8.0; 3], material);
    model.document["extensionsUsed"] = json!(["KHR_texture_transform", "KHR_materials_sheen"]);
    model.document["animations"] = json!([{}]);
    model.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = json!(0);
    model.document["meshes"][0]["primitives"][0]["targets"] = json!([{}]);
    let mut warnings = messages(&read(&model), Severity::Warning);
    warnings.sort();
    let mut expected: Vec<String> = [
        "its normalTexture is not read",
        "its occlusionTexture is not read",
        "its emissiveTexture is not read",
        "its baseColorTexture is not read",
        "its metallicRoughnessTexture is not read",
        "its specularTexture is not read",
        "KHR_materials_clearcoat is not read",
        "KHR_materials_sheen is not read",
        "KHR_materials_anisotropy is not read",
        "KHR_materials_iridescence is not read",
        "KHR_materials_unlit is not read",
        "its alphaMode BLEND is not read: it is opaque",
    ]
    .map(|what| format!("material 0 and 1 more: {what}"))
    .into();
    expected.extend(
        [
            "the file: KHR_texture_transform is not read",
            "the file: its animations are not read: nodes and joints are in their rest pose",
            "mesh 0: its vertex colours are not read",
            "morph targets are skipped",
        ]
        .map(str::to_owned),
    );
    expected.sort();
    assert_eq!(warnings, expected);
}

/// A primitive without a material has glTF's own: rough white metal.
#[test]
fn no_material_is_white_metal() {
    let mut model = block(json!({}));
    let primitive = &mut model.document["meshes"][0]["primitives"][0];
    primitive
        .as_object_mut()
        .expect("a primitive")
        .remove("material");
    let read = read(&model);
    let MaterialKind::Brdf(brdf) = &read.scene.materials[0].kind else {
        panic!("a light")
    };
    assert_eq!(
        (brdf.kd, brdf.ks, brdf.alpha),
        (DVec3::ZERO, DVec3::ONE, 1.0)
    );
}
