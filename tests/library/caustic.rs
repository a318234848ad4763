//! A red glass ball throws its red caustic on the table.

use vkpt::prepared::Prepared;
use vkpt::render::{Job, Target};
use vkpt::settings::Settings;

use crate::common::data::data;
use crate::common::render::{job, outcome, prepared};
use crate::common::stats::mean_and_error;

/// The line of the ball.
const BALL: &str = "sphere 0.500000 0.750000 0.690000 0.290000";
/// Where its caustic falls on the table, next to it in the picture of 400 × 300: left, top, right, bottom.
const PATCH: [u32; 4] = [190, 166, 216, 182];
const SEEDS: u32 = 24;

/// `classroom/glass.scn` with or without the ball; without the letters, whose files are elsewhere.
fn scene(with_ball: bool) -> Prepared {
    let text = std::fs::read_to_string(data("classroom/glass.scn")).expect("a scene");
    assert!(text.contains(BALL));
    let unwanted = |line: &&str| line.starts_with("mesh") || (!with_ball && *line == BALL);
    let lines: Vec<&str> = text.lines().filter(|line| !unwanted(line)).collect();
    prepared(&lines.join("\n"), &Settings::default())
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
    let [with, without] = [true, false].map(scene);
    let [a, b, c] = [
        ratios(&with, 0),
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
