//! Scenes that pbrt has no equivalent of.

use std::path::Path;

use vkpt_cli::export::pbrt::setting;

use super::*;
use crate::common::meshes::{ply, square};

#[test]
fn materials_without_an_equal_are_refused_by_line() {
    let exact = "fresnel exact";
    for (words, brdf, reason) in [
        ("#", ".1 .1 .1 .5 .5 .5 .3", Reason::Sum),
        (exact, ".1 0 0 0 0 0 0 .5 .5 .5 1.5", Reason::Sum),
        (exact, "0 0 0 0 0 0 60 .5 .5 .5 1.5", Reason::Phong),
        ("distribution beckmann", "0 0 0 1 1 1 .3", Reason::Beckmann),
        (
            "#",
            "0 0 0 .04 .04 .04 0 .5 .5 .5 1.5",
            Reason::SchlickGlass,
        ),
        ("#", "0 0 0 .9 .9 .9 0", Reason::SchlickMetal),
        ("#", "0 0 0 .9 .9 .9 .3", Reason::SchlickMetal),
        ("#", "0 0 0 1 1 1 9e-4", Reason::Narrow(9e-4)),
        (exact, "0 0 0 0 0 0 .1 .5 .5 .5 1.00009", Reason::WeakGlass),
        (exact, "0 0 0 0 0 0 0 .5 .5 0 1.5", Reason::OpaqueChannel),
    ] {
        let scene =
            format!("screen 8 8\ncamera 0 0 9 1\n{words}\n#\nbrdf {brdf}\nsphere 0 0 0 1\n");
        assert_eq!(refused(&scene), [(5, reason)], "{words}, {brdf}");
    }
}

#[test]
fn meshes_with_shading_normals_are_refused_and_lights_of_open_ones_are_not() {
    let with_normals = ply(
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n\
         property float nz\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n",
    );
    let open = square();
    let scene = |material: &str, file: &Path| {
        let file = file.display();
        format!("screen 8 8\ncamera 0 0 9 1\n{material}\nmesh {file} 0 0 0 1\n")
    };
    let grey = scene("brdf .5 .5 .5 0 0 0 1", with_normals.path());
    assert_eq!(refused(&grey), [(4, Reason::ShadingNormals)]);
    // A black surface has no use for them, and lights emit to both sides.
    export(&scene("light 1 1 1", with_normals.path()));
    export(&scene("light 1 1 1", open.path()));
}

#[test]
fn places_that_rounding_decides_are_refused() {
    let floor =
        "screen 8 8\ncamera 0 0 9 1\nfresnel exact\nbrdf .5 .5 .5 0 0 0 1\nbox -2 -2 -1 4 4 1\n";
    let glass = format!("{floor}brdf 0 0 0 0 0 0 0 .5 .5 .5 1.5\nbox -1 -1 0 2 2 1\n");
    assert_eq!(refused(&glass), [(7, Reason::Coincident(5))]);
    // A light about the eye emits inwards too.
    export("screen 8 8\ncamera 0 0 9 1\nlight 1 1 1\nsphere 0 0 9 2\n");
}

#[test]
fn settings_without_an_equal_are_named() {
    let default = Settings::default().model;
    assert_eq!(setting(&default), None);
    for (model, flag) in models_without_an_equal() {
        assert!(setting(&model).is_some_and(|message| message.starts_with(flag)));
    }
}
