//! Light tracing finds the same picture as path tracing, and a closed form, by the reference in f32, which the device equals
//! bit for bit (`tests/device/light_tracing.rs`).
//!
//! Block means of pictures by several seeds are compared by Welch's t-test: a light path contributes to many pixels, so
//! that those of one picture are not independent. Šidák over all blocks, settings and scenes at α = 1e-3; fixed seeds.

use std::path::Path;

use vkpt::render::Target;
use vkpt::settings::{Integrator, Roulette, Sampler, Settings};

use crate::common::meshes::cube;
use crate::common::render::{job, outcome, prepared};
use crate::common::scenes::{INSIDE, TABLE, WIDE};
use crate::common::stats::{p_of_difference, p_of_mean, sidak};
use crate::estimators::{Effort, MEANS, means, relative_error};

const ALPHA: f64 = 1e-3;
const SCENES: usize = 4;

/// A box of light within rough glass that absorbs, seen from outside, and a mesh of light in a corner.
pub fn lamps(cube: &Path) -> String {
    format!(
        "screen 32 24
camera 0 -6 3.4 .3 x 62
light 9 8 6
box -.2 -.2 .6 .4 .4 .4
light 3 4 5
mesh {} 2 1 .5 .4
brdf .5 .5 .5 0 0 0 1
box -5 -5 -.1 10 10 .1
distribution ggx
brdf 0 0 0 .04 .04 .04 .5 .8 .9 .7 1.5
sphere 0 0 .8 .7
",
        cube.display()
    )
}

fn scenes(cube: &Path) -> [(&'static str, String); SCENES] {
    [
        ("table", TABLE.to_owned()),
        ("wide", WIDE.to_owned()),
        ("lamps", lamps(cube)),
        ("inside", INSIDE.to_owned()),
    ]
}

/// The defaults, and each setting that affects light paths.
fn variants() -> Vec<(&'static str, Settings)> {
    let with = |change: fn(&mut Settings)| {
        let mut s = Settings::default();
        change(&mut s);
        s
    };
    vec![
        ("default", Settings::default()),
        (
            "no radiance scaling",
            with(|s| s.model.radiance_scaling = false),
        ),
        ("max-depth 2", with(|s| s.model.max_depth = Some(2))),
        (
            "roulette 0.8",
            with(|s| s.estimator.roulette = Roulette::Constant(0.8)),
        ),
        (
            "sampler random",
            with(|s| s.estimator.sampler = Sampler::Random),
        ),
    ]
}

fn light(mut settings: Settings) -> Settings {
    settings.estimator.integrator = Integrator::Light;
    settings
}

fn level() -> f64 {
    sidak(ALPHA, SCENES * variants().len() * MEANS)
}

/// Block means of a scene by one integrator, for each seed.
fn rendered(text: &str, settings: Settings, effort: Effort, seed: u32) -> Vec<Vec<f64>> {
    means(&prepared(text, &settings), settings, effort, seed)
}

/// The least p-value over the blocks of two sets of pictures.
pub fn least_p(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let p = a.iter().zip(b).map(|(a, b)| p_of_difference(a, b));
    p.fold(1.0, f64::min)
}

fn agree(effort: Effort) {
    let cube = cube();
    let (mut least, mut error) = (1.0, 0.0_f64);
    for (s, (scene, text)) in scenes(cube.path()).iter().enumerate() {
        for (k, (name, settings)) in variants().into_iter().enumerate() {
            let seed = (1000 * (20 * s + 2 * k)) as u32;
            let paths = rendered(text, settings, effort, seed);
            let lights = rendered(text, light(settings), effort, seed + 1000);
            let p = least_p(&paths, &lights);
            assert!(p > level(), "{scene}, {name}: p = {p:e}");
            least = f64::min(least, p);
            error = error
                .max(relative_error(&paths))
                .max(relative_error(&lights));
        }
    }
    println!(
        "least p-value {least:.1e}, level {:.1e}, largest standard error {error:.1e}",
        level()
    );
}

#[test]
fn both_integrators_have_the_same_mean() {
    agree(Effort { seeds: 16, spp: 32 });
}

#[test]
#[ignore = "up to an hour"]
fn both_integrators_have_the_same_mean_to_a_thousandth() {
    agree(Effort::LONG);
}

/// Refraction on light paths by the rule of eye paths: n² too much or too little, where light or eye is in glass.
#[test]
fn eta_squared_on_the_wrong_side_is_noticed() {
    let effort = Effort { seeds: 16, spp: 32 };
    let cube = cube();
    let mut wrong = Settings::default();
    wrong.model.radiance_scaling = false;
    for (name, text) in [("inside", INSIDE.to_owned()), ("lamps", lamps(cube.path()))] {
        let paths = rendered(&text, Settings::default(), effort, 1);
        let lights = rendered(&text, light(wrong), effort, 1001);
        let p = least_p(&paths, &lights);
        println!("{name}: p = {p:.1e}");
        assert!(p < level(), "{name}: p = {p:e}");
    }
}

/// A floor of Kd below a ball of light, which the camera above does not see: a pixel's row and column are y and x.
pub const FLOOR: &str = "screen 16 16
camera 0 0 4 .5
light 3 2 1
sphere 3.5 .5 1.5 .5
brdf .6 .5 .4 0 0 0 1
box -9 -9 -1 18 18 1
";

/// Radiance of the floor at (x, y, 0): Kd/π E with E = π L (r/d)² h/d, the irradiance from a ball that is wholly above the
/// plane (Lambert; Modest, Radiative Heat Transfer, view factor of a sphere).
pub fn floor_radiance(x: f64, y: f64) -> f64 {
    let to = glam::DVec3::new(3.5 - x, 0.5 - y, 1.5);
    let (r, d) = (0.5, to.length());
    0.6 * 3.0 * (r / d).powi(2) * to.z / d
}

/// The mean over each 4 × 4 block of pixels, by 32 × 32 points in a block.
fn floor_blocks() -> Vec<f64> {
    let at = |k: f64| 4.0 * 0.5 * (2.0 * k / 16.0 - 1.0);
    let block = |i: usize| {
        let (column, row) = ((i % 4 * 4) as f64, (i / 4 * 4) as f64);
        let point = |k: usize| {
            let (a, b) = ((k % 32) as f64 + 0.5, (k / 32) as f64 + 0.5);
            floor_radiance(at(column + a / 8.0), -at(row + b / 8.0))
        };
        (0..1024).map(point).sum::<f64>() / 1024.0
    };
    (0..16).map(block).collect()
}

/// Red of each block, for each of 24 seeds.
fn floor_pictures(factor: f64) -> Vec<Vec<f64>> {
    let settings = light(Settings::default());
    let scene = prepared(FLOOR, &settings);
    let mut blocks = vec![Vec::new(); 16];
    for seed in 0..24 {
        let film = outcome(&job(&scene, settings, 512, seed), &Target::CpuF32).film;
        let mut sums = [0.0; 16];
        for (i, rgb) in film.rgb.iter().enumerate() {
            sums[i / 64 * 4 + i % 16 / 4] += factor * f64::from(rgb[0]) / 16.0;
        }
        blocks
            .iter_mut()
            .zip(sums)
            .for_each(|(all, sum)| all.push(sum));
    }
    blocks
}

fn floor_p(factor: f64) -> f64 {
    let p = floor_pictures(factor)
        .into_iter()
        .zip(floor_blocks())
        .map(|(samples, expected)| p_of_mean(&samples, expected, 0.0));
    p.fold(1.0, f64::min)
}

#[test]
fn a_floor_under_a_ball_of_light_is_as_bright_as_lambert_says() {
    let level = sidak(ALPHA, 16);
    let p = floor_p(1.0);
    println!("least p-value {p:.1e}, level {level:.1e}");
    assert!(p > level, "p = {p:e}");
    for factor in [0.96, 1.04] {
        let p = floor_p(factor);
        assert!(p < level, "×{factor}: p = {p:e}");
    }
}
