//! Pictures by a lens: out of focus by closed form and quadrature, in focus those of a pinhole.
//!
//! Several seeds a picture, Student's t over their figures, or Welch's over those of two integrators; Šidák over each family at
//! α = 1e-3; fixed seeds.

use vkpt::film::Film;
use vkpt::render::Target;
use vkpt::settings::{Integrator, Settings};

use crate::common::defocus::{BALLS, Ball, found};
use crate::common::render::{film, prepared};
use crate::common::scenes::LENS;
use crate::common::settings::by;
use crate::common::stats::{p_of_mean, sidak};
use crate::estimators::{Effort, MEANS, means};
use crate::light_tracing::least_p;

pub const ALPHA: f64 = 1e-3;

pub const INTEGRATORS: [Integrator; 3] = [
    Integrator::Path,
    Integrator::Light,
    Integrator::Bidirectional,
];

/// One by each of so many seeds.
pub fn pictures(text: &str, integrator: Integrator, spp: u32, seeds: u32) -> Vec<Film> {
    let settings = by(integrator);
    let picture = |seed| film(text, settings, spp, seed, &Target::CpuF32);
    (0..seeds).map(picture).collect()
}

/// Rounding of sums in f32, for pictures without variance.
const ROUNDING: f64 = 1e-5;

/// The least p-value for a ball's picture to be the expected one.
fn ball_p(rendered: &Ball, expected: &Ball, integrator: Integrator) -> f64 {
    let found = found(expected, pictures(&rendered.scene(), integrator, 256, 12));
    if found.outside > 0.0 {
        return 0.0;
    }
    let p = [&found.whole, &found.inside].map(|samples| p_of_mean(samples, 1.0, ROUNDING));
    println!("{integrator:?}: {p:?}");
    p[0].min(p[1])
}

#[test]
fn a_ball_out_of_focus_is_a_disc() {
    let level = sidak(ALPHA, 2 * BALLS.len() * INTEGRATORS.len());
    for ball in BALLS {
        for integrator in INTEGRATORS {
            let p = ball_p(&ball, &ball, integrator);
            assert!(p > level, "{ball:?}, {integrator:?}: p = {p:e}");
        }
    }
}

/// 4 % more of a focus, of a lens or of a ball.
#[test]
fn another_lens_is_noticed() {
    let level = sidak(ALPHA, 2 * BALLS.len() * INTEGRATORS.len());
    for ball in BALLS {
        let planted = [
            Ball {
                lens: 1.04 * ball.lens,
                ..ball
            },
            Ball {
                focus: 1.04 * ball.focus,
                ..ball
            },
            Ball {
                radius: 1.04 * ball.radius,
                ..ball
            },
        ];
        for wrong in planted {
            let p = ball_p(&wrong, &ball, Integrator::Light);
            assert!(p < level, "{wrong:?} for {ball:?}: p = {p:e}");
        }
    }
}

/// A plane of light with an edge between two pixels.
fn edge(lens: &str) -> String {
    format!("screen 16 8\ncamera 0 0 0 .4\n{lens}\nlight 1 1 1\nbox 0 -9 -3.00001 9 18 1e-5\n")
}

#[test]
fn objects_in_focus_equal_the_pinholes_picture() {
    let [pinhole, lens] = ["", "lens .5 3"]
        .map(|lens| film(&edge(lens), Settings::default(), 64, 1, &Target::CpuF32));
    assert_eq!(pinhole, lens);
    assert_eq!(pinhole.rgb[7], [0.0; 3]);
    assert_eq!(pinhole.rgb[8], [1.0; 3]);
}

/// The share of a disc on one side of a line that passes its middle at u radii: 1/2 + (u √(1 − u²) + asin u)/π, by 64 points of
/// a column. A ray that meets the plane's edge from aside sees 1e-5 of its thickness.
#[test]
fn an_edge_out_of_focus_fades_as_the_share_of_a_disc_does() {
    // c = R |F − z|/(F z)
    let (text, c) = (edge("lens .5 6"), 0.5 * 3.0 / (6.0 * 3.0));
    let share = |u: f64| match u.abs() < 1.0 {
        true => 0.5 + (u * (1.0 - u * u).sqrt() + u.asin()) / std::f64::consts::PI,
        false => {
            if u > 0.0 {
                1.0
            } else {
                0.0
            }
        }
    };
    let column = |k: usize| {
        let x = |i: usize| 0.8 * (2.0 * (k as f64 + (i as f64 + 0.5) / 64.0) / 16.0 - 1.0);
        (0..64).map(|i| share(x(i) / c)).sum::<f64>() / 64.0
    };
    let films = pictures(&text, Integrator::Path, 256, 16);
    let level = sidak(ALPHA, 16);
    for k in 0..16 {
        let mean = |f: &Film| {
            (0..8)
                .map(|row| f64::from(f.rgb[16 * row + k][0]))
                .sum::<f64>()
                / 8.0
        };
        let samples: Vec<f64> = films.iter().map(mean).collect();
        let p = p_of_mean(&samples, column(k), ROUNDING);
        assert!(
            p > level,
            "column {k}: p = {p:e}, {} for {}",
            samples[0],
            column(k)
        );
    }
}

/// All that a path may meet, near a lens as wide as the view.
#[test]
fn all_integrators_have_the_same_mean() {
    let effort = Effort { seeds: 16, spp: 32 };
    let level = sidak(ALPHA, 2 * MEANS);
    let of = |integrator, seed| {
        let settings = by(integrator);
        means(&prepared(LENS, &settings), settings, effort, seed)
    };
    let paths = of(Integrator::Path, 1);
    for (integrator, seed) in [(Integrator::Light, 101), (Integrator::Bidirectional, 201)] {
        let p = least_p(&paths, &of(integrator, seed));
        println!("{integrator:?}: p = {p:.1e}, level {level:.1e}");
        assert!(p > level, "{integrator:?}: p = {p:e}");
    }
}
