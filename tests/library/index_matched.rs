//! Null interfaces, |ior − 1| < 1e-7, have only absorption (model.md, "The null interface"): paths and shadow rays go straight
//! through, attenuated by exactly Kt^t, and no bounce is counted. Both settings of absorption agree.

use vkpt::render::Target;
use vkpt::settings::{Absorption, Connect, Settings};

use crate::common::render::{film, job, outcome, prepared};
use crate::common::stats::{noticeable, p_of_mean, sidak};

const ALPHA: f64 = 1e-3;
/// Of a dozen factors in f32, one of them exp(−σt) with the rounding of t.
const ROUNDING: f64 = 1e-5;
const KT: [f64; 3] = [0.5, 0.7, 0.9];
/// An index-matched solid: only its absorption has an effect.
const STAIN: &str = "brdf 0 0 0 0 0 0 0 .5 .7 .9 1\n";
const BOTH: [Absorption; 2] = [Absorption::Segment, Absorption::Term];

fn settings(absorption: Absorption, max_depth: u32) -> Settings {
    let mut settings = Settings::default();
    settings.model.absorption = absorption;
    settings.model.max_depth = Some(max_depth);
    settings
}

/// Kt^t along the chord t = 2√(1 − a²) of a unit sphere, with no bounce allowed.
#[test]
fn a_straight_path_is_attenuated_by_its_length() {
    for absorption in BOTH {
        for a in [0.0f64, 0.3, 0.8, 0.99] {
            let text = format!(
                "screen 4 4\ncamera {a} 0 5 1e-9\nbackground 1 1 1\n{STAIN}sphere 0 0 0 1\n"
            );
            let settings = settings(absorption, 0);
            let scene = prepared(&text, &settings);
            let outcome = outcome(&job(&scene, settings, 4, 1), &Target::CpuF32);
            assert_eq!(outcome.stats.rays, 3 * outcome.stats.samples);
            let t = 2.0 * (1.0 - a * a).sqrt();
            for pixel in &outcome.film.rgb {
                for (x, kt) in pixel.iter().zip(KT) {
                    let off = f64::from(*x) / kt.powf(t) - 1.0;
                    assert!(
                        off.abs() < ROUNDING,
                        "{absorption:?}, a = {a}: off by {off:e}"
                    );
                }
            }
        }
    }
}

/// A lamp right above, so small that its light is parallel to 1e-8, through a slab of unit thickness: each picture
/// is Kt times that without the slab, pixel by pixel, at one bounce.
#[test]
fn a_shadow_ray_is_attenuated_by_its_length() {
    let floor = "screen 8 8\ncamera 0 -.5 .5 1e-3 x 45\nlight 1e6 1e6 1e6\nsphere 0 0 200 .01\n\
                 brdf .6 .6 .6 0 0 0 1\nbox -5 -5 -1 10 10 1\n";
    let slab = format!("{floor}{STAIN}box -5 -5 1 10 10 1\n");
    for absorption in BOTH {
        for connect in [Connect::Mis, Connect::Light] {
            let mut settings = settings(absorption, 1);
            settings.estimator.connect = connect;
            let [without, with] =
                [floor, &slab].map(|text| film(text, settings, 4, 1, &Target::CpuF32));
            for (a, b) in without.rgb.iter().zip(&with.rgb) {
                for c in 0..3 {
                    assert!(a[c] > 0.0);
                    let off = f64::from(b[c]) / f64::from(a[c]) / KT[c] - 1.0;
                    assert!(
                        off.abs() < ROUNDING,
                        "{absorption:?}, {connect:?}: off by {off:e}"
                    );
                }
            }
        }
    }
}

/// L = 2 Kd ∫ Kt^(d/u) u du over u = cos θ from h/√(r² + h²) to 1: a disc of radius r and radiance 1 at height h over
/// a Lambert plane, and a stain of thickness d between. Connections and hits must be weighted alike through it.
#[test]
fn a_disc_light_through_a_stain() {
    let (r, h, d, kd) = (0.5, 0.8, 0.3, 0.7);
    let text = format!(
        "screen 24 24\ncamera 0 -.2 .2 1e-6 x 45\nbrdf {kd} {kd} {kd} 0 0 0 10\nbox -50 -50 -1 100 100 1\n\
         light 1 1 1\ncylinder 0 0 {h} 0 0 1e-4 {r}\n{STAIN}box -9 -9 .4 18 18 {d}\n"
    );
    let expected = KT.map(|kt: f64| {
        let u0 = h / f64::hypot(r, h);
        2.0 * kd * simpson(u0, 1.0, |u| kt.powf(d / u) * u)
    });
    let level = sidak(ALPHA, 2 * 3 * 3);
    for absorption in BOTH {
        for connect in [Connect::Mis, Connect::Light, Connect::Bsdf] {
            let mut settings = settings(absorption, 1);
            settings.estimator.connect = connect;
            let film = film(&text, settings, 64, 1, &Target::CpuF32);
            for c in 0..3 {
                let samples: Vec<f64> = film.rgb.iter().map(|p| f64::from(p[c])).collect();
                let p = |expected| p_of_mean(&samples, expected, 0.0);
                let right = p(expected[c]);
                assert!(right > level, "{absorption:?}, {connect:?}: p = {right:e}");
                // 1 %, or the least that this many paths can detect: nothing contributes more than right below the disc,
                // through the stain.
                let (connected, hit) = (kd * r * r / (h * h), kd);
                let most = KT[c].powf(d)
                    * match connect {
                        Connect::Mis => connected + hit,
                        Connect::Light => connected,
                        Connect::Bsdf => hit,
                    };
                let detectable = noticeable(level, expected[c], most, 24.0 * 24.0 * 64.0, 24 * 24);
                let wrong = expected[c] + detectable.max(0.01 * expected[c]);
                assert!(
                    p(wrong) < level,
                    "{absorption:?}, {connect:?}: {wrong} passes"
                );
            }
        }
    }
}

/// Simpson's rule with a thousand intervals.
fn simpson(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    const N: usize = 1000;
    let step = (b - a) / N as f64;
    let weight = |i: usize| match i {
        0 | N => 1.0,
        _ if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let sum: f64 = (0..=N).map(|i| weight(i) * f(a + step * i as f64)).sum();
    sum * step / 3.0
}
