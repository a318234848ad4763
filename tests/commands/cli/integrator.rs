//! `--integrator`: its refusals and its warnings.

use insta::assert_snapshot;

use super::program::{SCENE, folder, names, run, shown};

/// Expects a wrong command line and an untouched folder; the command and its message.
fn refused(line: &str) -> String {
    let folder = folder(SCENE);
    let arguments: Vec<&str> = line.split(' ').collect();
    let run = run(folder.path(), &arguments);
    assert_eq!(run.code, Some(2), "{line}: {}", run.err);
    assert_eq!(names(folder.path()), ["scene.scn"], "{line}");
    shown(&arguments, &run.err)
}

#[test]
fn settings_without_light_paths_are_refused() {
    let lines = [
        "scene.scn --integrator light --absorption term",
        "scene.scn --integrator light --model handout",
        "scene.scn --integrator light --trace 0,0,0",
        "compare --paired scene.scn --integrator light",
        "converge scene.scn --integrator light --vary absorption=segment,term",
    ];
    assert_snapshot!(lines.map(refused).concat());
}

#[test]
fn settings_without_bidirectional_paths_are_refused() {
    let lines = [
        "scene.scn --integrator bidirectional --absorption term",
        "scene.scn --integrator bidirectional --connect bsdf",
    ];
    assert_snapshot!(lines.map(refused).concat());
}

#[test]
fn parts_that_light_paths_do_not_see_give_one_warning() {
    let lacking = format!("background 1 1 1\n{SCENE}brdf 0 0 0 1 1 1 0\nsphere 3 0 0 1\n");
    for (scene, warnings) in [(SCENE, 0), (&lacking, 1)] {
        for (integrator, warnings) in [("path", 0), ("light", warnings)] {
            let folder = folder(scene);
            let arguments = [
                "scene.scn",
                "--device",
                "cpu-f32",
                "--spp",
                "2",
                "--integrator",
                integrator,
            ];
            let run = run(folder.path(), &arguments);
            assert_eq!(run.code, Some(0), "{}", run.err);
            let printed = run
                .err
                .matches("does not render reflections in mirrors or the background");
            assert_eq!(printed.count(), warnings, "{integrator}: {}", run.err);
        }
    }
}

/// A ball of light next to a ball of glass.
const GLASS: &str = "screen 16 12
camera 0 -6 2 .35 x 75
light 5 5 4
sphere -2 0 3 .3
brdf .5 .5 .5 0 0 0 1
box -5 -5 -.1 10 10 .1
brdf 0 0 0 .04 .04 .04 .2 .9 .9 .9 1.5
sphere 0 0 .8 .8
";

/// The features of the scene decide, the last line says so, and the picture is the chosen integrator's.
#[test]
fn a_scene_chooses_its_integrator() {
    let skies = format!("{GLASS}background .1 .1 .1\n");
    let plaster = GLASS.replace("brdf 0 0 0 .04 .04 .04 .2 .9 .9 .9 1.5\n", "");
    let lamp = GLASS.replace("sphere -2 0 3 .3", "sphere -2 0 3 1.5");
    let rows: [(&str, &[&str], &str, &str); 6] = [
        (
            &lamp,
            &[],
            "path",
            "the lights are large, and paths from the eye hit them",
        ),
        (
            GLASS,
            &[],
            "bidirectional",
            "small lights illuminate mirrors or glass",
        ),
        (
            GLASS,
            &["--absorption", "term"],
            "path",
            "--absorption term has no adjoint for light paths",
        ),
        (
            GLASS,
            &["--connect", "light"],
            "path",
            "--connect applies only to paths from the eye",
        ),
        (
            &skies,
            &[],
            "path",
            "most light comes from the background, which paths from the eye find",
        ),
        (&plaster, &[], "path", "nothing mirrors or refracts"),
    ];
    for (text, flags, integrator, why) in rows {
        let folder = folder(text);
        let base = ["scene.scn", "--spp", "4", "--device", "cpu-f32"];
        let of = |asked: &[&str], out| {
            let run = run(
                folder.path(),
                &[&base[..], flags, asked, &["-o", out]].concat(),
            );
            assert_eq!(run.code, Some(0), "{}", run.err);
            (
                run.out,
                std::fs::read(folder.path().join(out)).expect("a picture"),
            )
        };
        let (words, default) = of(&[], "default.png");
        let why = format!("{integrator} by auto: {why}");
        assert!(words.trim_end().ends_with(&why), "{words}");
        let (words, auto) = of(&["--integrator", "auto"], "auto.png");
        assert!(words.trim_end().ends_with(&why), "{words}");
        let (words, asked) = of(&["--integrator", integrator], "asked.png");
        assert!(!words.contains("by auto"), "{words}");
        assert!(auto == asked && default == asked, "{integrator}");
    }
}

/// Variants differ only in the settings that are varied: all have the integrator that suits each of them.
#[test]
fn variants_share_the_integrator_that_the_scene_chooses() {
    let rows: [(&str, [&str; 2]); 3] = [
        ("connect=mis,light", ["path", "path"]),
        ("lights=power,contribution", ["bidirectional"; 2]),
        ("integrator=path,auto", ["path", "bidirectional"]),
    ];
    for (vary, expected) in rows {
        let folder = folder(GLASS);
        let base = [
            "converge",
            "scene.scn",
            "--device",
            "cpu-f32",
            "--time",
            "0.2",
        ];
        let more = ["--replicates", "2", "--json", "c.json", "--vary", vary];
        let run = run(folder.path(), &[&base[..], &more].concat());
        assert_eq!(run.code, Some(0), "{}", run.err);
        let text = std::fs::read_to_string(folder.path().join("c.json")).expect("a report");
        let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let variants = json["variants"].as_array().expect("variants");
        let of = |v: &serde_json::Value| v["settings"]["integrator"].as_str().map(str::to_owned);
        let found: Vec<String> = variants.iter().filter_map(of).collect();
        assert_eq!(found, expected, "{vary}");
    }
}
