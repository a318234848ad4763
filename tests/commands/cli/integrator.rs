//! `--integrator`: what it refuses and what it warns of.

use super::program::{SCENE, folder, names, run};

#[test]
fn what_light_paths_cannot_do_is_refused() {
    let rows: [(&[&str], &str); 5] = [
        (
            &["scene.scn", "--absorption", "term"],
            "Add --absorption segment",
        ),
        (&["scene.scn", "--model", "handout"], "--model handout"),
        (
            &["scene.scn", "--trace", "0,0,0"],
            "leave --integrator light out",
        ),
        (
            &["compare", "--paired", "scene.scn"],
            "leave --integrator light out",
        ),
        (
            &["converge", "scene.scn", "--vary", "absorption=segment,term"],
            "Add --absorption segment",
        ),
    ];
    for (arguments, said) in rows {
        let folder = folder(SCENE);
        let run = run(
            folder.path(),
            &[arguments, &["--integrator", "light"]].concat(),
        );
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.err);
        assert!(run.err.contains(said), "{arguments:?}: {}", run.err);
        assert_eq!(names(folder.path()), ["scene.scn"], "{arguments:?}");
    }
}

#[test]
fn what_bidirectional_paths_cannot_do_is_refused() {
    let rows: [(&[&str], &str); 4] = [
        (
            &["scene.scn", "--absorption", "term"],
            "leave --integrator bidirectional out",
        ),
        (&["scene.scn", "--connect", "bsdf"], "leave --connect out"),
        (
            &["scene.scn", "--trace", "0,0,0"],
            "leave --integrator bidirectional out",
        ),
        (
            &["compare", "--paired", "scene.scn"],
            "leave --integrator bidirectional out",
        ),
    ];
    for (arguments, said) in rows {
        let folder = folder(SCENE);
        let run = run(
            folder.path(),
            &[arguments, &["--integrator", "bidirectional"]].concat(),
        );
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.err);
        assert!(run.err.contains(said), "{arguments:?}: {}", run.err);
        assert_eq!(names(folder.path()), ["scene.scn"], "{arguments:?}");
    }
}

#[test]
fn what_light_paths_do_not_see_is_warned_of_once() {
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
            let told = run
                .err
                .matches("does not see what mirrors show, nor the background");
            assert_eq!(told.count(), warnings, "{integrator}: {}", run.err);
        }
    }
}
