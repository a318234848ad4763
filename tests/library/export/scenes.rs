//! Which of the project's own scenes can be exported where, and the reasons why others cannot: the table of docs/exchange.md,
//! word by word.

use std::collections::BTreeSet;
use std::fmt::Debug;
use std::fs;
use std::path::PathBuf;

use vkpt::prepared::prepare;
use vkpt::settings::Settings;
use vkpt_cli::export::gltf::Container;
use vkpt_cli::export::{Export, Remark, Subject, gltf, mitsuba, pbrt};

use crate::common::root;

/// Each scene, and the reasons for which Mitsuba, pbrt and glTF refuse it.
const SCENES: [(&str, &str, &str, &str); 22] = [
    ("scenes/absorption", "", "", "Background ExactGlass Sphere"),
    (
        "scenes/caustic",
        "SchlickGlass Sum",
        "SchlickGlass Sum",
        "Cylinder Sphere",
    ),
    ("scenes/diffuse", "", "", "Sphere"),
    (
        "scenes/frosted-globe",
        "Coincident Sum",
        "Coincident Sum",
        "Cylinder ExactGlass Sphere",
    ),
    ("scenes/furnace", "", "", "ExactGlass Sphere"),
    (
        "scenes/glass-mesh",
        "ShadingNormals",
        "ShadingNormals",
        "Background ExactGlass Sphere",
    ),
    (
        "scenes/glass-table",
        "Sum",
        "SchlickMetal Sum",
        "Background Cylinder ExactGlass Phong Sphere",
    ),
    (
        "scenes/lens",
        "Sum",
        "Sum",
        "Background ExactGlass Lens Sphere",
    ),
    (
        "scenes/many-lights",
        "Sum",
        "SchlickMetal Sum",
        "Background Cylinder ExactGlass Sphere",
    ),
    (
        "scenes/prism-mirror",
        "SchlickMirror",
        "SchlickMetal",
        "Cylinder ExactGlass",
    ),
    (
        "scenes/room",
        "",
        "SchlickMetal",
        "Cylinder ExactGlass Sphere",
    ),
    (
        "scenes/rough-pane",
        "Sum",
        "SchlickMetal Sum",
        "Cylinder ExactGlass Sphere",
    ),
    (
        "scenes/roughness-beckmann",
        "Beckmann Coincident",
        "Beckmann Coincident SchlickMetal",
        "Background Beckmann Sphere",
    ),
    (
        "scenes/roughness-ggx",
        "Coincident",
        "Coincident SchlickMetal",
        "Background ExactGlass Sphere",
    ),
    (
        "scenes/roughness-phong",
        "Coincident Phong",
        "Coincident Phong SchlickMetal",
        "Background Phong Sphere",
    ),
    ("scenes/slab", "", "", "ExactGlass"),
    (
        "scenes/surroundings",
        "SchlickGlass SchlickMirror Surroundings",
        "SchlickGlass SchlickMetal Surroundings",
        "Background Cylinder Sphere",
    ),
    ("scenes/veach-plates", "Sum", "Sum", "Background Sphere"),
    (
        "benches/peers/scenes/defocus",
        "",
        "",
        "Background Lens Sphere",
    ),
    (
        "benches/peers/scenes/facets",
        "",
        "SchlickMetal",
        "Background ExactGlass",
    ),
    (
        "benches/peers/scenes/gloss",
        "",
        "SchlickMetal",
        "Background Cylinder ExactGlass Sphere",
    ),
    (
        "benches/peers/scenes/inside",
        "",
        "",
        "Background ExactGlass Sphere",
    ),
];

/// The names of the reasons, each once.
fn reasons<R: Debug>(exported: Result<Export, Vec<Remark<R>>>) -> String {
    let refusals = exported.err().unwrap_or_default();
    let names = refusals.iter().map(|r| format!("{:?}", r.reason));
    let names: BTreeSet<String> = names
        .map(|name| name.split('(').next().unwrap_or_default().to_owned())
        .collect();
    Vec::from_iter(names).join(" ")
}

#[test]
fn each_scene_is_exported_or_refused_by_name() {
    let root = root();
    for (name, by_mitsuba, by_pbrt, by_gltf) in SCENES {
        let path = root.join(format!("{name}.txt"));
        let scene = vkpt::scene::read(&path, false).expect("a scene").scene;
        let settings = Settings::default();
        let prepared = prepare(&scene, &settings, None).expect("a scene that can be prepared");
        let subject = Subject {
            scene: &scene,
            prepared: &prepared,
            model: &settings.model,
            crop: None,
            stem: "a",
        };
        assert_eq!(
            reasons(mitsuba::export(&subject)),
            by_mitsuba,
            "{name}, Mitsuba"
        );
        assert_eq!(reasons(pbrt::export(&subject)), by_pbrt, "{name}, pbrt");
        assert_eq!(
            reasons(gltf::export(&subject, Container::Glb)),
            by_gltf,
            "{name}, glTF"
        );
    }
}

#[test]
fn no_scene_is_left_out() {
    let root = root();
    let files = |folder: &str| {
        let files = fs::read_dir(root.join(folder)).expect("a folder").flatten();
        let paths = files.map(|file| file.path());
        let scenes = paths.filter(|path| path.extension().is_some_and(|ending| ending == "txt"));
        scenes.collect::<BTreeSet<PathBuf>>()
    };
    let all = &files("scenes") | &files("benches/peers/scenes");
    let listed = SCENES.map(|(name, ..)| root.join(format!("{name}.txt")));
    assert_eq!(all, BTreeSet::from(listed));
}

#[test]
fn every_command_of_the_language_has_a_row() {
    let page = include_str!("../../../docs/scenes.md");
    let (_, commands) = page.split_once("| command | meaning |\n").expect("a table");
    let rows = commands.lines().take_while(|line| line.starts_with('|'));
    let words = rows.filter_map(|row| row.strip_prefix("| `")?.split([' ', '`']).next());
    let words: BTreeSet<&str> = words.collect();
    assert!(words.contains("screen") && words.contains("mesh"));
    let exchange = include_str!("../../../docs/exchange.md");
    let firsts = exchange.lines().filter_map(|line| line.split(" | ").next());
    let firsts: Vec<&str> = firsts.filter(|cell| cell.starts_with('|')).collect();
    for word in words {
        let named = format!("`{word}");
        assert!(firsts.iter().any(|cell| cell.contains(&named)), "{word}");
    }
}
