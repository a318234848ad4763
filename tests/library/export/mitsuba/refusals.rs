//! Scenes that Mitsuba has no equivalent of.

use std::path::Path;

use vkpt_cli::export::mitsuba::setting;

use super::*;
use crate::common::meshes::{cube, ply, square};

/// A scene whose line 5 is this material.
fn of(words: &str, brdf: &str) -> String {
    format!("screen 8 8\ncamera 0 0 9 1\n{words}\n#\nbrdf {brdf}\nsphere 0 0 0 1\n")
}

#[test]
fn materials_without_an_equal_are_refused_by_line() {
    for (words, brdf, reason) in [
        ("#", ".1 .1 .1 .5 .5 .5 .3", Reason::Sum),
        ("#", ".1 .1 .1 1 1 1 0", Reason::Sum),
        ("fresnel exact", ".1 0 0 0 0 0 0 .5 .5 .5 1.5", Reason::Sum),
        ("#", "0 0 0 .5 .5 .5 60", Reason::Phong),
        (
            "fresnel exact",
            "0 0 0 0 0 0 60 .5 .5 .5 1.5",
            Reason::Phong,
        ),
        (
            "distribution beckmann",
            "0 0 0 .5 .5 .5 .3",
            Reason::Beckmann,
        ),
        ("distribution beckmann", "0 0 0 1 1 1 .3", Reason::Beckmann),
        (
            "#",
            "0 0 0 .04 .04 .04 0 .5 .5 .5 1.5",
            Reason::SchlickGlass,
        ),
        (
            "#",
            "0 0 0 .04 .04 .04 .3 .5 .5 .5 1.5",
            Reason::SchlickGlass,
        ),
        ("#", "0 0 0 .9 .9 .9 0", Reason::SchlickMirror),
        ("#", "0 0 0 .9 .9 .9 9e-4", Reason::NarrowGloss(9e-4)),
        (
            "fresnel exact",
            "0 0 0 0 0 0 .1 .5 .5 .5 1.00009",
            Reason::WeakGlass,
        ),
    ] {
        assert_eq!(refused(&of(words, brdf)), [(5, reason)], "{words}, {brdf}");
    }
}

#[test]
fn a_material_of_no_shape_is_not_refused() {
    let unused = "screen 8 8\ncamera 0 0 9 1\nbrdf .1 .1 .1 .5 .5 .5 .3\nbrdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1\n";
    assert_eq!(plugins(&document(&export(unused)), "bsdf").len(), 2);
}

#[test]
fn every_reason_is_given_once_in_the_order_of_the_file() {
    let scene = "screen 8 8\ncamera 0 0 9 1\nbrdf 0 0 0 .9 .9 .9 0\nsphere 0 0 0 1\nbrdf .1 .1 .1 .5 .5 .5 .3\n\
                 sphere 3 0 0 1\nbrdf 0 0 0 .8 .8 .8 0\nsphere 6 0 0 1\n";
    let refusals = export_by(scene, &Settings::default()).err();
    let refusals = refusals.expect("something is refused");
    let printed: Vec<_> = refusals.iter().map(|r| (r.line, r.more)).collect();
    assert_eq!(printed, [(3, 1), (5, 0)]);
    assert!(refusals[0].to_string().ends_with(" (and 1 more line)"));
}

#[test]
fn meshes_whose_sides_differ_are_refused() {
    let (open, closed) = (square(), cube());
    let with_normals = ply(
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n\
         property float nz\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n",
    );
    let scene = |material: &str, file: &Path| {
        let file = file.display();
        format!("screen 8 8\ncamera 0 0 9 1\n{material}\nmesh {file} 0 0 0 1\n")
    };
    let grey = "brdf .5 .5 .5 0 0 0 1";
    assert_eq!(
        refused(&scene("light 1 1 1", open.path())),
        [(4, Reason::OpenLight)]
    );
    assert_eq!(
        refused(&scene(grey, with_normals.path())),
        [(4, Reason::ShadingNormals)]
    );
    export(&scene("light 1 1 1", closed.path()));
    export(&scene(grey, open.path()));
}

#[test]
fn places_that_rounding_decides_are_refused() {
    let scene = |shapes: &str| format!("screen 8 8\ncamera 0 0 9 1\nfresnel exact\n{shapes}");
    let floor = "brdf .5 .5 .5 0 0 0 1\nbox -2 -2 -1 4 4 1\n";
    // Glass on a floor, and a box that ends where another of another colour does.
    let glass = format!("{floor}brdf 0 0 0 0 0 0 0 .5 .5 .5 1.5\nbox -1 -1 0 2 2 1\n");
    assert_eq!(refused(&scene(&glass)), [(7, Reason::Coincident(5))]);
    let flush = format!("{floor}brdf .9 .5 .5 0 0 0 1\nbox -1 -1 -.5 2 2 .5\n");
    assert_eq!(refused(&scene(&flush)), [(7, Reason::Coincident(5))]);
    // No path reaches between opaque solids, and a colour equals itself.
    export(&scene(&format!(
        "{floor}brdf .9 .5 .5 0 0 0 1\nbox -1 -1 0 2 2 1\n"
    )));
    export(&scene(&format!("{floor}box -1 -1 -.5 2 2 .5\n")));
    let within = "light 1 1 1\nsphere 0 0 9 2\n";
    assert_eq!(refused(&scene(within)), [(5, Reason::EyeInLight)]);
}

#[test]
fn settings_without_an_equal_are_named() {
    let default = Settings::default().model;
    assert_eq!(setting(&default), None);
    for (model, flag) in models_without_an_equal() {
        assert!(setting(&model).is_some_and(|message| message.starts_with(flag)));
    }
}
