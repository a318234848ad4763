//! Scenes that glTF cannot express.

use vkpt::settings::{Fresnel, Model};
use vkpt_cli::export::gltf::setting;

use super::*;
use crate::common::meshes::ply;
use crate::export::{models_without_an_equal, refusals};

/// Each refused line and why.
fn refused(text: &str) -> Vec<(usize, Reason)> {
    refusals(glb(text, &Settings::default()))
}

/// A scene whose line 6 is this material.
fn of(words: &str, brdf: &str) -> String {
    format!(
        "screen 8 8\ncamera 0 0 9 1\nlight 1 1 1\nbox 0 5 0 1 1 1\n{words}\nbrdf {brdf}\nbox 0 0 0 1 1 1\n"
    )
}

#[test]
fn materials_without_an_equal_are_refused_by_line() {
    for (words, brdf, reason) in [
        ("#", ".1 .1 .1 0 0 0 0 .5 .5 .5 1.5", Reason::Sum),
        ("#", "0 0 0 .5 .5 .5 60", Reason::Phong),
        ("distribution beckmann", "0 0 0 1 1 1 .3", Reason::Beckmann),
        (
            "fresnel exact",
            "0 0 0 0 0 0 0 .5 .5 .5 1.5",
            Reason::ExactGlass,
        ),
        ("#", "0 0 0 0 0 0 0 .5 .5 .5 .7", Reason::ThinIndex),
    ] {
        assert_eq!(refused(&of(words, brdf)), [(6, reason)], "{words}, {brdf}");
    }
    let mut settings = Settings::default();
    settings.model.fresnel = Some(Fresnel::Schlick);
    let glass = of("fresnel exact", "0 0 0 .04 .04 .04 0 .5 .5 .5 1.5");
    glb(&glass, &settings).expect("a flag beats the word");
}

#[test]
fn shapes_that_are_no_triangles_are_refused() {
    for (shape, reason) in [
        ("sphere 0 0 0 1", Reason::Sphere),
        ("cylinder 0 0 0 0 0 1 1", Reason::Cylinder),
    ] {
        let scene = of("#", ".5 .5 .5 0 0 0 1").replace("box 0 0 0 1 1 1", shape);
        assert_eq!(refused(&scene), [(7, reason)]);
    }
    let flat = ply(
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n\
         property float nz\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n3 0 1 2\n",
    );
    let mesh = format!("mesh {} 0 0 0 1", flat.path().display());
    let scene = of("#", ".5 .5 .5 0 0 0 1").replace("box 0 0 0 1 1 1", &mesh);
    assert_eq!(refused(&scene), [(7, Reason::NoNormal)]);
    assert_eq!(
        refused("screen 8 8\ncamera 0 0 9 1\nbackground 1 1 1\n"),
        [(2, Reason::Nothing)]
    );
}

#[test]
fn surroundings_must_be_white_without_lights_and_else_black() {
    let scene = |light: &str, outside: &str| {
        format!("screen 8 8\ncamera 0 0 9 1\n{outside}\n{light}\nbox 0 0 0 1 1 1\n")
    };
    let (lamp, grey) = ("light 1 1 1", "brdf .5 .5 .5 0 0 0 1");
    for (light, outside, line) in [
        (lamp, "background .1 .1 .1", 3),
        (grey, "background .5 .5 .5", 3),
        (lamp, "background 1 1 1", 3),
    ] {
        assert_eq!(
            refused(&scene(light, outside)),
            [(line, Reason::Background)]
        );
    }
    assert_eq!(refused(&scene(grey, "#")), [(2, Reason::Dark)]);
    for (light, outside) in [
        (lamp, "#"),
        (lamp, "background 0 0 0"),
        (grey, "background 1 1 1"),
    ] {
        let bytes = glb(&scene(light, outside), &Settings::default()).expect("nothing is refused");
        let back = read_from(Cursor::new(bytes), Path::new("a.glb"), true, None)
            .expect("glTF")
            .scene;
        let shines = if light == grey { 1.0 } else { 0.0 };
        assert_eq!(back.background.to_array(), [shines; 3]);
    }
    let lens = scene(lamp, "lens .1 5");
    assert_eq!(refused(&lens), [(3, Reason::Lens)]);
}

#[test]
fn settings_without_an_equal_are_named() {
    let default = Settings::default().model;
    assert_eq!(setting(&default, None), None);
    let short = Model {
        max_depth: Some(3),
        ..default
    };
    let own = models_without_an_equal().map(|(model, flag)| (model, None, flag));
    let gltfs = [
        (short, None, "--max-depth"),
        (default, Some([0, 0, 1, 1]), "--crop"),
    ];
    for (model, crop, flag) in own.into_iter().chain(gltfs) {
        assert!(setting(&model, crop).is_some_and(|message| message.starts_with(flag)));
    }
}
