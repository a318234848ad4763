//! Lenses as wide as the scene and wider, next to the objects, and focused next to the eye or beyond the resolution of f32.

use crate::check::case::{Case, Expectation, Stiffness};

const GLASS: &str = "fresnel exact\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5";
const BLACK: &str = "brdf 0 0 0 0 0 0 1";

pub fn cases() -> Vec<Case> {
    let clear = "smooth glass only deflects light, and the sky is 1 in every direction";
    let ball = |name: &str, about: &str, lens: &str| {
        seen(name, about, lens, GLASS, "sphere 0 0 0 1").mean(1.0, clear)
    };
    vec![
        ball("narrow", "a lens 1e-20 wide", "1e-20 4"),
        ball(
            "wide",
            "a lens 1e4 times as wide as the ball in view",
            "1e4 4",
        )
        .expect(Expectation::Warning("the focal plane".into())),
        ball(
            "near-focus",
            "the focal plane is 1e-6 in front of the eye: rays run along the lens",
            "1 1e-6",
        )
        .expect(Expectation::Warning("the focal plane".into())),
        ball(
            "far-focus",
            "the focal plane is 1e30 away: all rays of a point of the picture are parallel",
            "1 1e30",
        ),
        ball(
            "in-focus-edge",
            "the ball's edge is in the focal plane",
            "1 4",
        ),
        seen(
            "reaches-through",
            "a lens whose centre is in a ball of glass, and whose edge is outside",
            ".8 4",
            GLASS,
            "sphere 0 0 3.2 1",
        )
        .expect(Expectation::Warning("reaches through".into())),
        seen(
            "on-floor",
            "a lens on a black floor, facing away from it",
            "2 4",
            BLACK,
            "box -8 -8 4 16 16 1",
        )
        .mean(1.0, "nothing is in front of it"),
        disc("disc-behind", "a ball of light behind the focal plane", "1"),
        disc(
            "disc-before",
            "a ball of light in front of the focal plane",
            "1e3",
        ),
        disc("disc-sharp", "a ball of light in the focal plane", "4"),
    ]
}

/// The eye is 4 above the origin and looks down.
fn seen(name: &str, about: &str, lens: &str, material: &str, shape: &str) -> Case {
    let text = format!(
        "screen 16 16\ncamera 0 0 4 .3\nlens {lens}\nbackground 1 1 1\n{material}\n{shape}\n"
    );
    let wide: f64 = lens
        .split(' ')
        .next()
        .and_then(|r| r.parse().ok())
        .unwrap_or(1.0);
    let stiff = Stiffness::new(
        4.0,
        64.0 * wide.max(1.0),
        1.0,
        "4 per hit of a curved body, 3 hits, from places as large as the lens; all weights are 1",
    );
    Case::new(format!("lens/{name}"), about, text, stiff)
}

/// A ball of light of radius r = .2, 4 deep, seen by a lens of radius R = .2. A pinhole s beside the axis sees it as an ellipse of
/// the area π r² √(g + s²)/√g³, g = 4² − r², on the plane at distance 1; the mean of √(g + s²) over the lens is
/// 2 ((g + R²)^(3/2) − g^(3/2))/(3 R²). The whole of its disc is on the picture, whose area is 4 · .3².
fn disc(name: &str, about: &str, focus: &str) -> Case {
    let (r, radius): (f64, f64) = (0.2, 0.2);
    let g = 16.0 - r * r;
    let root = 2.0 * ((g + radius * radius).powf(1.5) - g.powf(1.5)) / (3.0 * radius * radius);
    let area = std::f64::consts::PI * r * r * root / g.powf(1.5);
    let text = format!(
        "screen 16 16\ncamera 0 0 4 .3\nlens {radius} {focus}\nlight 1 1 1\nsphere 0 0 0 {r}\n"
    );
    let stiff = Stiffness::new(
        1.0,
        64.0 * 4.0 / r,
        1.0,
        "places 4/.2 as large as the ball; it is hit or not",
    );
    Case::new(format!("lens/{name}"), about, text, stiff)
        .spp(256)
        .weight(1.0, "the ball's radiance")
        .mean(
            area / 0.36,
            "the ball's area on the picture plane, from each point of the lens",
        )
}
