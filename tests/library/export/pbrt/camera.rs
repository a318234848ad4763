//! The directives before the world.

use super::*;

const AIR: &str = "screen 400 200\ncamera 1 2 3 0.5 z 90\nbackground .1 .1 .1\nbrdf .5 .5 .5 0 0 0 1\nsphere 1 2 -5 1\n";
const GLASS: &str =
    "screen 8 8\ncamera 0 0 0 1\nfresnel exact\nbrdf 0 0 0 0 0 0 0 .5 .5 .5 1.5\nsphere 0 0 0 2\n";

#[test]
fn the_world_is_moved_before_a_camera_that_looks_along_z() {
    let exported = export(AIR);
    let m = &exported.only("Transform").numbers;
    // Column by column. A point before the eye, one to its right and one above it: right is Y, up is −X.
    let seen = |p: [f64; 3]| {
        [0, 1, 2].map(|i| p[0] * m[i] + p[1] * m[4 + i] + p[2] * m[8 + i] + m[12 + i])
    };
    same(&seen([1.0, 2.0, 3.0]), &[0.0, 0.0, 0.0], "the eye");
    same(&seen([1.0, 2.0, -2.0]), &[0.0, 0.0, 5.0], "before it");
    same(&seen([1.0, 3.0, 3.0]), &[1.0, 0.0, 0.0], "to the right");
    same(&seen([0.0, 2.0, 3.0]), &[0.0, 1.0, 0.0], "above");
}

#[test]
fn the_field_of_view_is_that_of_the_shorter_side() {
    // 2 atan .5, and 2 atan .25
    for (screen, fov) in [
        ("screen 400 200", 53.130_102_354_155_98),
        ("screen 100 200", 28.072_486_935_852_957),
    ] {
        let exported = export(&AIR.replace("screen 400 200", screen));
        check(exported.only("Camera"), "float fov", &[fov]);
    }
    let film = export(AIR);
    check(film.only("Film"), "integer xresolution", &[400.0]);
    check(film.only("Film"), "integer yresolution", &[200.0]);
    // pbrt rounds to half precision by default.
    assert_eq!(film.only("Film").values("bool savefp16"), ["false"]);
}

#[test]
fn a_lens_keeps_its_radius_and_its_focal_distance() {
    let lens = export(&format!("{AIR}lens .25 7\n"));
    check(lens.only("Camera"), "float lensradius", &[0.25]);
    check(lens.only("Camera"), "float focaldistance", &[7.0]);
    assert_eq!(
        export(&format!("{AIR}lens 0 7\n"))
            .only("Camera")
            .parameters
            .len(),
        1
    );
}

#[test]
fn bounces_are_counted_alike() {
    let mut settings = Settings::default();
    settings.model.max_depth = Some(2);
    let limited = export_by(AIR, &settings).expect("nothing is refused");
    check(limited.only("Integrator"), "integer maxdepth", &[2.0]);
    // pbrt's default would be 5.
    check(
        export(AIR).only("Integrator"),
        "integer maxdepth",
        &[2_147_483_647.0],
    );
}

#[test]
fn the_background_is_a_light_where_there_is_one() {
    check(export(AIR).only("LightSource"), "rgb L", &[0.1; 3]);
    assert!(export(GLASS).all("LightSource").is_empty());
}

#[test]
fn an_eye_in_glass_is_in_its_medium() {
    let interfaces = |scene: &str| {
        let exported = export(scene);
        let all = exported.statements.iter();
        let before = all.take_while(|s| s.directive != "Camera");
        let media = before.filter(|s| s.directive == "MediumInterface");
        media.map(|s| s.words.clone()).collect::<Vec<_>>()
    };
    assert_eq!(interfaces(GLASS), [["", "medium-4"]]);
    assert!(interfaces(AIR).is_empty());
}
