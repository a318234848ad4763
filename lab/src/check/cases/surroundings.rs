//! Pictures of the surroundings: peaks, rows at the poles and on the horizon, a single texel, a huge range.

use std::f64::consts::PI;

use crate::check::case::{Case, Stiffness};
use vkpt::film::Film;

pub fn cases() -> Vec<Case> {
    vec![
        constant(1, 1),
        constant(7, 5),
        row("pole", 256, 0),
        row("pole-of-many", 8192, 0),
        row("horizon", 256, 127),
        sun("sun", 1e5, 1e-3),
        sun("fierce-sun", 1e15, 1e-15),
        sun("lone-sun", 1e5, 0.0),
        glass(),
    ]
}

const KD: f64 = 0.5;
const FLOOR: &str = "brdf .5 .5 .5 0 0 0 1\nbox -100 -100 -1 200 200 1\n";

fn stiff() -> Stiffness {
    let why =
        "texels and densities are looked up; a position sampled within one is off by an ulp or two";
    Stiffness::new(2.0, 1.0, 1.0, why)
}

fn picture(width: u32, height: u32, radiance: impl Fn(u32, u32) -> f64) -> Film {
    let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Film {
        width,
        height,
        rgb: texels.map(|(x, y)| [radiance(x, y) as f32; 3]).collect(),
    }
}

/// A floor under a picture, seen from above.
fn floor(name: &str, about: &str, picture: Film) -> Case {
    let text = format!("screen 16 16\ncamera 0 0 1 1e-9\nbackground 0 0 0\n{FLOOR}");
    Case::new(format!("surroundings/{name}"), about, text, stiff()).surroundings(picture)
}

fn constant(width: u32, height: u32) -> Case {
    let about = format!("{width}×{height} equal texels");
    let name = format!("constant-{width}x{height}");
    floor(&name, &about, picture(width, height, |_, _| 1.0)).mean(KD, "Kd L")
}

/// θ from straight up of a row's upper and lower edge.
fn edges(row: u32, height: u32) -> [f64; 2] {
    [row, row + 1].map(|edge| PI * f64::from(edge) / f64::from(height))
}

/// One row emits light: Kd/π ∫ cos θ dω = Kd (sin² θ₁ − sin² θ₀), written without cancellation.
fn row(name: &str, height: u32, lit: u32) -> Case {
    let [upper, lower] = edges(lit, height);
    let value = KD * (lower - upper).sin() * (lower + upper).sin();
    let about = format!("only row {lit} of {height} emits light");
    let radiance = |_: u32, y: u32| f64::from(u32::from(y == lit));
    floor(name, &about, picture(4, height, radiance)).mean(value, "Kd (sin² θ₁ − sin² θ₀)")
}

/// A texel of radiance `sun` in a sky of `sky`: Kd L Δφ/2π (sin² θ₁ − sin² θ₀) and Kd times the rest of the sky.
fn sun(name: &str, sun: f64, sky: f64) -> Case {
    let (width, height, x, y) = (256, 128, 77, 40);
    let [upper, lower] = edges(y, height);
    let share = (lower - upper).sin() * (lower + upper).sin() / f64::from(width);
    let value = KD * (sun * share + sky * (1.0 - share));
    let about = format!("a texel of radiance {sun:e} in a sky of {sky:e}");
    let radiance = |i: u32, j: u32| if (i, j) == (x, y) { sun } else { sky };
    floor(name, &about, picture(width, height, radiance))
        .mean(value, "Kd L Ω cos θ/π, texel by texel")
}

/// A ball of clear glass that loses nothing, in a world of radiance 1.
fn glass() -> Case {
    let text = "screen 16 16\ncamera 0 0 6 .17\nbackground 0 0 0\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\nsphere 0 0 0 1\n";
    let stiff = Stiffness::new(12.0, 10.0, 1.0, "a dozen refractions at glancing angles");
    Case::new(
        "surroundings/glass",
        "clear glass in uniform surroundings",
        text,
        stiff,
    )
    .surroundings(picture(16, 8, |_, _| 1.0))
    .mean(1.0, "all light that enters leaves")
}
