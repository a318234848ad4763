//! The course's glass scene: the small red ball throws its red caustic on the table.

use std::path::Path;

use vkpt::prepared::{Prepared, prepare};
use vkpt::render::{Job, Target};
use vkpt::settings::Settings;

use crate::common::render::{job, outcome};
use crate::common::stats::mean_and_error;

const SCENE: &str = "../shared/scenes/p4-transmission.scn";
/// The line of the small red ball.
const BALL: &str = "sphere 0.500000 1.10000 0.700000 0.3";
/// Where its caustic falls on the table, beside it in the picture of 400 × 300: left, top, right, bottom.
const PATCH: [u32; 4] = [248, 162, 276, 176];
const SEEDS: u32 = 24;

fn scene(text: &str) -> Prepared {
    let read = vkpt::scene::parse(text, Path::new(SCENE), false).expect("the course's scene");
    prepare(&read.scene, &Settings::default(), None).expect("a scene that can be rendered")
}

/// Mean R / mean G of the patch, seed by seed.
fn ratios(scene: &Prepared, first_seed: u32) -> Vec<f64> {
    let ratio = |seed| {
        let job = Job {
            crop: Some(PATCH),
            ..job(scene, Settings::default(), 16, seed)
        };
        let film = outcome(&job, &Target::CpuF32).film;
        let mean = |c: usize| film.rgb.iter().map(|p| f64::from(p[c])).sum::<f64>();
        mean(0) / mean(1)
    };
    (first_seed..first_seed + SEEDS).map(ratio).collect()
}

/// By how many standard errors the mean of `a` is above that of `b`.
fn z_above(a: &[f64], b: &[f64]) -> f64 {
    let ((mean_a, error_a), (mean_b, error_b)) = (mean_and_error(a), mean_and_error(b));
    (mean_a - mean_b) / error_a.hypot(error_b)
}

#[test]
fn the_red_ball_throws_a_red_caustic() {
    let Ok(text) = std::fs::read_to_string(SCENE) else {
        println!("skipped: {SCENE} is not there");
        return;
    };
    assert!(text.contains(BALL));
    let without = scene(&text.replace(BALL, "#"));
    let [a, b, c] = [
        ratios(&scene(&text), 0),
        ratios(&without, 100),
        ratios(&without, 200),
    ];
    let z = z_above(&a, &b);
    println!(
        "R/G {:?} with the ball, {:?} without: z = {z:.1}",
        mean_and_error(&a),
        mean_and_error(&b)
    );
    assert!(z > 5.0, "z = {z}");
    // The same patch without the ball, twice: no difference.
    let none = z_above(&b, &c);
    assert!(
        none.abs() < 4.0,
        "z = {none} between two pictures of the same"
    );
}
