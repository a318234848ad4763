//! Eyes in glass, and exactly on a surface; pictures of one pixel and of 8192 × 8192.

use crate::check::case::{Case, Expectation, Stiffness};

const GLASS: &str = "fresnel exact\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5";
const BLACK: &str = "brdf 0 0 0 0 0 0 1";

pub fn cases() -> Vec<Case> {
    vec![
        seen(
            "in-glass",
            "an eye in the middle of a ball of glass",
            "0 0 0 .3",
            GLASS,
            "sphere 0 0 0 1",
        )
        .mean(
            2.25,
            "n² times the sky's radiance, however the light is deflected",
        ),
        seen(
            "on-ball-out",
            "an eye exactly on a black ball, looking away",
            "0 0 1 .1 x 180",
            BLACK,
            "sphere 0 0 0 1",
        )
        .mean(1.0, "nothing is in front of it"),
        seen(
            "on-ball-in",
            "an eye exactly on a ball of glass, looking in",
            "0 0 1 .1",
            GLASS,
            "sphere 0 0 0 1",
        )
        .expect(Expectation::Warning("the eye is on".into())),
        seen(
            "on-floor-up",
            "an eye exactly on a black floor, looking up",
            "0 0 0 .1 x 180",
            BLACK,
            "box -8 -8 -1 16 16 1",
        )
        .mean(1.0, "nothing is in front of it"),
        seen(
            "on-floor-level",
            "an eye exactly on a black floor, looking level",
            "0 0 0 .1 x 90",
            BLACK,
            "box -8 -8 -1 16 16 1",
        )
        .mean(0.5, "half of the picture is sky"),
        seen(
            "one-pixel",
            "a picture of 1 × 1",
            "0 0 4 .3",
            GLASS,
            "sphere 0 0 0 1",
        )
        .spp(1024)
        .mean(1.0, "smooth glass"),
        seen(
            "one-sample",
            "one sample a pixel",
            "0 0 4 .3",
            GLASS,
            "sphere 0 0 0 1",
        )
        .spp(1)
        .weight(1.0, "smooth glass only deflects light")
        .mean(1.0, "smooth glass"),
        seen(
            "8192x8192",
            "the last corner of a picture of 8192 × 8192",
            "0 0 4 .3",
            GLASS,
            "sphere 0 0 0 2",
        )
        .crop([8184, 8184, 8192, 8192])
        .mean(1.0, "smooth glass"),
    ]
}

fn seen(name: &str, about: &str, camera: &str, material: &str, shape: &str) -> Case {
    let size = match name {
        "one-pixel" => "1 1",
        "8192x8192" => "8192 8192",
        _ => "16 16",
    };
    let text = format!("screen {size}\ncamera {camera}\nbackground 1 1 1\n{material}\n{shape}\n");
    let stiff = Stiffness::new(
        4.0,
        64.0,
        1.0,
        "4 per hit of a curved body, 3 hits; all weights are 1",
    );
    Case::new(format!("camera/{name}"), about, text, stiff)
}
