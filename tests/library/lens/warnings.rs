//! The refusals and the warnings of a lens.

use std::path::Path;

use vkpt::prepared::prepare;
use vkpt::settings::Settings;

const GLASS: &str = "brdf 0 0 0 .04 .04 .04 0 1 1 1 1.5";
const MATTE: &str = "brdf .5 .5 .5 0 0 0 1";

/// The eye is the origin, looks along −Z.
fn warnings(lens: &str, shape: &str) -> Vec<String> {
    let text = format!("screen 40 30\ncamera 0 0 0 .2\nlens {lens}\nbackground 1 1 1\n{shape}\n");
    let read = vkpt::scene::parse(&text, Path::new("test.txt"), true).expect("a legal scene");
    prepare(&read.scene, &Settings::default(), None)
        .expect("a scene")
        .warnings
}

#[test]
fn a_lens_that_reaches_through_a_surface_gives_a_warning() {
    let crossing = [
        // The eye outside and the edge inside, the other way round, a ball within the disc, a floor below the eye.
        format!("{GLASS}\nsphere .8 0 0 .5"),
        format!("{MATTE}\nsphere 0 0 0 .3"),
        format!("{MATTE}\nsphere .2 .1 0 .05"),
        format!("{MATTE}\nbox -5 -1 -5 10 .7 10"),
        format!("{GLASS}\ncylinder .3 0 -1 0 0 2 .1"),
    ];
    for shape in crossing {
        let found = warnings(".5 4", &shape);
        let expected = "line 3: the lens reaches through the surface of the shape of line 6";
        assert!(
            found.iter().any(|w| w.starts_with(expected)),
            "{shape}: {found:?}"
        );
    }
    let beside = [
        // Too far aside, around the lens, before it and behind it, parallel to it.
        format!("{GLASS}\nsphere .8 0 0 .2"),
        format!("{GLASS}\nsphere 0 0 0 .6"),
        format!("{MATTE}\nsphere 0 0 -.4 .3"),
        format!("{MATTE}\nbox -5 -5 .01 10 10 1"),
    ];
    for shape in beside {
        let found = warnings(".5 4", &shape);
        assert!(found.is_empty(), "{shape}: {found:?}");
    }
}

/// 2⁻²³ (R/F)² of a pixel's .4/30: a pixel at R/F = 334.
#[test]
fn a_lens_too_wide_for_its_focal_distance_gives_a_warning() {
    for (lens, wide) in [
        ("1200 4", false),
        ("1e-3 3.3e-6", false),
        ("1400 4", true),
        ("1e-3 2.7e-6", true),
    ] {
        let found = warnings(lens, "");
        let expected = found.iter().any(|w| {
            w.starts_with("line 3: the lens is 3e2 times")
                || w.starts_with("line 3: the lens is 4e2")
        });
        assert_eq!(expected, wide, "{lens}: {found:?}");
    }
}

/// Every number is finite in single precision; the squares of rays are not.
#[test]
fn a_lens_beyond_single_precision_is_refused_by_its_line() {
    for (lens, fits) in [
        ("1e10 1e-5", true),
        ("1e-20 1e-20", true),
        ("1 1e30", true),
        ("3e38 3e38", true),
        ("1 1e-30", false),
        ("3e38 1", false),
    ] {
        let text = format!("screen 40 30\ncamera 0 0 9 .2\nlens {lens}\n{MATTE}\nsphere 0 0 0 1\n");
        let read = vkpt::scene::parse(&text, Path::new("test.txt"), true).expect("a legal scene");
        let found = prepare(&read.scene, &Settings::default(), None).map_err(|e| e.to_string());
        match found {
            Ok(p) => {
                let lens = p.lens.expect("a lens");
                assert!(fits && lens.right.length() <= 2.0 && (lens.blur as f32).is_finite());
            }
            Err(e) => assert!(!fits && e.starts_with("line 3: the lens"), "{lens}: {e}"),
        }
    }
}
