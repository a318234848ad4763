//! The furnace for which other renderers' results are known: a ball of glass, GGX of width .1, and of Beckmann. At a scale of 1e-5
//! Mitsuba 3.9 falls from .945 to .480, and refuses an index of 1; at an index of 10 LuxCore 2.11 returns up to 4.5, and
//! pixels of 213.

use crate::check::case::{Case, Expectation, Stiffness};
use vkpt::settings::{Connect, Settings};

const SCALES: [&str; 8] = [
    "1e-5", "1e-4", "1e-2", "1e2", "1e5", "2^-17", "2^17", "2^100",
];

const UNIT: &str = "yardstick/1";

pub fn cases() -> Vec<Case> {
    let scaled = SCALES.map(|scale| {
        let power = scale.strip_prefix("2^").and_then(|p| p.parse().ok());
        let case = ball(
            format!("yardstick/{scale}"),
            power.map_or(scale.parse().unwrap_or(1.0), f64::exp2),
            1.5,
        );
        case.expect(match power {
            Some(_) => Expectation::SameBits {
                case: UNIT.into(),
                why: "a power of two scales every number and rounds none".into(),
            },
            None => Expectation::SameMean {
                case: UNIT.into(),
                why: "no length is special".into(),
            },
        })
    });
    let bounded =
        |case: Case| case.at_most(1.0, "Smith's masking loses light and makes none: R + T ≤ 1");
    let nothing = ball("yardstick/ior-1".into(), 1.0, 1.0)
        .weight(1.0, "there is no surface")
        .mean(1.0, "there is no surface");
    let mut cases = vec![bounded(ball(UNIT.into(), 1.0, 1.5))];
    cases.extend(scaled);
    cases.extend([
        nothing,
        bounded(ball("yardstick/ior-10".into(), 1.0, 10.0)),
        bounded(by_chance()),
        rim(),
    ]);
    cases
}

/// Along the rim, light is reflected inside many times, each with a weight. Sampling normals that are not visible makes
/// these weights vary strongly, which this mean shows: with the GGX normals of the same width it had 68 times the variance.
///
/// The mean is by quadrature over slopes and over the cosine that a chord in a ball keeps, 320 of them, of all
/// reflections within: .98771 over the disc, which has π/15 of (2 · .28)².
fn rim() -> Case {
    let text = "screen 64 64\ncamera 0 0 4 .28\nbackground 1 1 1\nfresnel exact\ndistribution beckmann\n\
                brdf 0 0 0 .04 .04 .04 .1 1 1 1 1.5\nsphere 0 0 0 1\n";
    let why = "4 per hit of a curved body, 3 hits; n² next to the critical angle";
    Case::new(
        "yardstick/beckmann-rim",
        "a ball of Beckmann .1, ior 1.5, to its rim",
        text,
        Stiffness::new(4.0, 144.0, 144.0, why),
    )
    .spp(64)
    .mean(0.99179, "quadrature over slopes, of all reflections within")
}

/// If light is found by BSDF sampling alone, a path contributes the product of its weights, none of which is above 1.
fn by_chance() -> Case {
    let mut settings = Settings::default();
    settings.estimator.connect = Connect::Bsdf;
    ball("yardstick/ior-10-by-chance".into(), 1.0, 10.0)
        .settings(settings)
        .weight(1.0, "GGX's weights are F, 1 − F and G1 (Heitz 2018)")
}

fn ball(name: String, scale: f64, ior: f64) -> Case {
    let text = format!(
        "screen 16 16\ncamera 0 0 {} .3\nbackground 1 1 1\nfresnel exact\ndistribution ggx\n\
         brdf 0 0 0 .04 .04 .04 .1 1 1 1 {ior}\nsphere 0 0 0 {scale}\n",
        4.0 * scale
    );
    // η² of the radicand of refraction, next to the critical angle (`interface`), in addition to the 4 per hit of a curved body.
    let condition = 64.0 * ior * ior;
    let why = "4 per hit of a curved body, 3 hits; n² next to the critical angle";
    Case::new(
        name,
        format!("a ball of GGX .1, ior {ior}, radius {scale:e}"),
        text,
        Stiffness::new(4.0, condition, condition, why),
    )
    .spp(32)
}
