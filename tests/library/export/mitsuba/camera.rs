//! The camera, the film, the integrator and the background.

use vkpt::settings::Settings;

use super::*;

const AIR: &str = "screen 400 200\ncamera 1 2 3 0.5 z 90\nbackground .1 .2 .3\nbrdf .5 .5 .5 0 0 0 1\nsphere 1 2 -5 1\n";
const GLASS: &str =
    "screen 8 8\ncamera 0 0 0 1\nfresnel exact\nbrdf 0 0 0 0 0 0 0 .5 1 1 1.5\nsphere 0 0 0 2\n";

#[test]
fn the_camera_is_turned_and_looks_along_z() {
    let exported = export(AIR);
    let document = document(&exported);
    let [sensor] = plugins(&document, "sensor")[..] else {
        panic!("one sensor")
    };
    assert_eq!(kind(&sensor), "perspective");
    assert_eq!(word(&sensor, "fov_axis"), "y");
    // 2 atan 0.5
    check(&sensor, "fov", &[53.130_102_354_155_98]);
    // Turned by 90° about Z: right is Y, up is −X; Mitsuba's X is to the left, its Z forwards.
    check_matrix(
        &sensor,
        &[
            0.0, -1.0, 0.0, 1.0, -1.0, 0.0, 0.0, 2.0, 0.0, 0.0, -1.0, 3.0, 0.0, 0.0, 0.0, 1.0,
        ],
    );
    let film = plugins(&document, "film")[0];
    check(&film, "width", &[400.0]);
    check(&film, "height", &[200.0]);
    assert_eq!(kind(&plugins(&document, "rfilter")[0]), "box");
}

#[test]
fn a_lens_keeps_its_radius_and_its_focal_distance() {
    for (line, expected) in [("lens .25 7", "thinlens"), ("lens 0 7", "perspective")] {
        let exported = export(&format!("{AIR}{line}\n"));
        let document = document(&exported);
        let sensor = plugins(&document, "sensor")[0];
        assert_eq!(kind(&sensor), expected);
        if expected == "thinlens" {
            check(&sensor, "aperture_radius", &[0.25]);
            check(&sensor, "focus_distance", &[7.0]);
        }
    }
}

#[test]
fn the_background_is_an_emitter_where_there_is_one() {
    let exported = export(AIR);
    let emitter = plugins(&document(&exported), "emitter")
        .first()
        .map(|emitter| {
            check(emitter, "radiance", &[0.1, 0.2, 0.3]);
            kind(emitter).to_owned()
        });
    assert_eq!(emitter.as_deref(), Some("constant"));
    assert!(!export(GLASS).xml.contains("<emitter"));
}

#[test]
fn the_integrator_follows_media_where_there_are_some() {
    let limited = {
        let mut settings = Settings::default();
        settings.model.max_depth = Some(2);
        settings
    };
    for (scene, settings, integrator, depth, roulette) in [
        (AIR, Settings::default(), "path", -1.0, 3.0),
        (AIR, limited, "path", 3.0, 3.0),
        (GLASS, Settings::default(), "volpathmis", -1.0, 1000.0),
    ] {
        let exported = export_by(scene, &settings).expect("nothing is refused");
        let document = document(&exported);
        let node = plugins(&document, "integrator")[0];
        assert_eq!(kind(&node), integrator);
        check(&node, "max_depth", &[depth]);
        check(&node, "rr_depth", &[roulette]);
    }
}

#[test]
fn an_eye_in_glass_is_in_its_medium() {
    let exported = export(GLASS);
    let document = document(&exported);
    let sensor = plugins(&document, "sensor")[0];
    let medium = parameter(&sensor, "medium");
    assert_eq!(medium.attribute("id"), Some("medium-4"));
}
