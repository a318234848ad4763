//! Surroundings: which texel is seen along a direction, and how texels are drawn, against closed forms of angles in f64.

use glam::{DQuat, DVec3};
use vkpt::prepared;
use vkpt::reference::light::surroundings::surroundings_texel_pdf;
use vkpt::reference::light::surroundings::{surroundings_direction, surroundings_texel};
use vkpt::reference::light::{Surroundings, surroundings_light_sample};
use vkpt::reference::math::{Real, Vec3};
use vkpt::settings::Settings;

use super::ALPHA;
use crate::common::render::prepared;
use crate::common::stats::{chi_square, sidak};
use crate::common::surroundings::{background, picture, place, solid_angle, theta};
use crate::shape::random::Random;

const LAST: f64 = 1.0 - 1.0 / 16_777_216.0;

/// A scene with only a picture.
fn surroundings(
    width: u32,
    height: u32,
    words: &str,
    radiance: impl Fn(u32, u32) -> [f32; 3],
) -> prepared::Surroundings {
    let picture = picture(width, height, radiance);
    let text = format!(
        "screen 4 3\ncamera 0 0 0 1\n{}",
        background(&picture, words)
    );
    let prepared = prepared(&text, &Settings::default());
    prepared.surroundings.expect("not black")
}

/// Grey, of all kinds: black texels, a black row, a row of one texel, and a peak.
fn uneven(x: u32, y: u32) -> [f32; 3] {
    let value = match (x, y) {
        (_, 3) => 0.0,
        (x, 5) if x != 6 => 0.0,
        (7, 2) => 300.0,
        (x, _) if x % 4 == 1 => 0.0,
        (x, y) => ((x * 7 + y * 3) % 11) as f32 * 0.3 + 0.1,
    };
    [value, value * 0.5, value * 2.0]
}

fn luminance([r, g, b]: [f32; 3]) -> f64 {
    0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
}

/// Directions whose texel is another than angles say, of those that are not within `margin` of a texel from an edge.
fn wrong_texels<F: Real>(
    s: &prepared::Surroundings,
    rotate: DQuat,
    margin: f64,
    place: fn(DVec3) -> [f64; 2],
) -> usize {
    let scalar = Surroundings::<F>::new(s);
    let (width, height) = (s.map.width, s.map.height);
    let mut random = Random(11);
    let mut wrong = 0;
    for _ in 0..20_000 {
        let d = random.direction::<F>();
        let [u, v] = place(rotate.inverse() * d.f64());
        let (x, y) = (u * f64::from(width), v * f64::from(height));
        let near = |x: f64| (x - x.round()).abs() < margin;
        let expected = y as u32 * width + x as u32;
        wrong += usize::from(!near(x) && !near(y) && surroundings_texel(&scalar, d) != expected);
    }
    wrong
}

#[test]
fn a_direction_sees_the_texel_of_its_angles() {
    let turned = DQuat::from_rotation_z(30f64.to_radians()) * DQuat::from_rotation_x(-1.0);
    for (words, rotate) in [("", DQuat::IDENTITY), ("z 30 x -57.29577951308232", turned)] {
        let s = surroundings(61, 33, words, uneven);
        assert_eq!(wrong_texels::<f64>(&s, rotate, 1e-9, place), 0);
        assert_eq!(wrong_texels::<f32>(&s, rotate, 61.0 * 2e-6, place), 0);
    }
}

#[test]
fn a_mirrored_and_a_flipped_picture_and_another_frame_are_noticed() {
    let s = surroundings(61, 33, "", uneven);
    let mirrored = |d: DVec3| [1.0 - place(d)[0], place(d)[1]];
    let flipped = |d: DVec3| [place(d)[0], 1.0 - place(d)[1]];
    assert!(wrong_texels::<f32>(&s, DQuat::IDENTITY, 1e-3, mirrored) > 0);
    assert!(wrong_texels::<f32>(&s, DQuat::IDENTITY, 1e-3, flipped) > 0);
    let another = DQuat::from_rotation_z(0.02);
    assert!(wrong_texels::<f32>(&s, another, 1e-3, place) > 0);
}

/// As the format's page says: the middle is +X, the upper edge +Z, and +Y a quarter of the width to the left.
#[test]
fn axes_are_where_the_format_says() {
    let s = Surroundings::<f32>::new(&surroundings(8, 4, "", uneven));
    let at = |x: f64, y: f64, z: f64| {
        let texel = surroundings_texel(&s, Vec3::new(DVec3::new(x, y, z).normalize()));
        (texel % 8, texel / 8)
    };
    assert_eq!(at(1.0, 1e-3, 1e-3), (3, 1));
    assert_eq!(at(1.0, -1e-3, -1e-3), (4, 2));
    assert_eq!(at(1e-3, 1.0, 1e-3), (2, 1));
    assert_eq!(at(-1e-3, 1.0, 1e-3), (1, 1));
    assert_eq!(at(-1.0, 1e-3, 1e-3), (0, 1));
    assert_eq!(at(-1.0, -1e-3, 1e-3), (7, 1));
    assert_eq!(at(0.0, 0.0, 1.0).1, 0);
    assert_eq!(at(0.0, 0.0, -1.0).1, 3);
    // On the seam, and with zeros of both signs.
    assert_eq!(at(-1.0, 0.0, 0.0).0, 0);
    assert!(at(-1.0, -0.0, 0.0).0 % 7 == 0);
}

/// Σ pdf ω = 1, and each is its share of luminance times solid angle, except for the rounding to counts out of 2²⁴: one of its
/// row's and one of its own, and one for each positive weight.
#[test]
fn texels_have_the_density_of_their_luminance() {
    for (width, height) in [(16, 8), (9, 7), (1, 1), (300, 2), (2, 301)] {
        let s = surroundings(width, height, "2.5", uneven);
        let scalar = Surroundings::<f64>::new(&s);
        let weight = |x, y| luminance(uneven(x, y)) * solid_angle(y, width, height);
        let row = |y| (0..width).map(|x| weight(x, y)).sum::<f64>();
        let total: f64 = (0..height).map(row).sum();
        let mut whole = 0.0;
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let p = surroundings_texel_pdf(&scalar, y * width + x) * solid_angle(y, width, height);
            let expected = weight(x, y) / total;
            let of_row = row(y) / total;
            let count = 1.0 / 16_777_216.0;
            let rounding =
                count * (f64::from(height) + 1.0) + of_row * count * (f64::from(width) + 1.0);
            assert!(
                (p - expected).abs() <= rounding,
                "{x},{y} of {width}×{height}"
            );
            assert_eq!(p == 0.0, expected == 0.0);
            whole += p;
        }
        assert!((whole - 1.0).abs() < 1e-12, "{whole}");
    }
}

/// Draws of `n` directions by texel.
fn drawn<F: Real>(s: &Surroundings<F>, n: usize, seed: u64) -> Vec<usize> {
    let mut random = Random(seed);
    let mut counts = vec![0; s.ends.len()];
    for _ in 0..n {
        let u = [random.unit(), random.unit()].map(F::new);
        let sample = surroundings_light_sample(s, u);
        assert!((sample.wi.f64().length() - 1.0).abs() < 1e-6);
        assert_eq!(sample.pdf, surroundings_texel_pdf(s, sample.prim));
        counts[sample.prim as usize] += 1;
    }
    counts
}

#[test]
fn texels_are_drawn_by_their_luminance_and_solid_angle() {
    const N: usize = 200_000;
    let (width, height) = (16, 8);
    let s = surroundings(width, height, "z 20 y 40", uneven);
    let by = |weight: &dyn Fn(u32, u32) -> f64| -> Vec<f64> {
        let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let weights: Vec<f64> = texels.map(|(x, y)| weight(x, y)).collect();
        let total: f64 = weights.iter().sum();
        weights.iter().map(|w| w / total * N as f64).collect()
    };
    let expected = by(&|x, y| luminance(uneven(x, y)) * solid_angle(y, width, height));
    let level = sidak(ALPHA, 2);
    let of_f32 = drawn(&Surroundings::<f32>::new(&s), N, 1);
    let of_f64 = drawn(&Surroundings::<f64>::new(&s), N, 2);
    for counts in [&of_f32, &of_f64] {
        let p = chi_square(counts, &expected);
        assert!(p > level, "p = {p:e}");
    }
    // Without the solid angle, and by one channel.
    let flat = by(&|x, y| luminance(uneven(x, y)));
    assert!(chi_square(&of_f32, &flat) < level);
    let lit = by(&|x, y| (luminance(uneven(x, y)) + 0.01) * solid_angle(y, width, height));
    assert!(chi_square(&of_f32, &lit) < level);
}

/// Within a texel directions are uniform by solid angle: in φ and cos θ.
#[test]
fn directions_are_uniform_within_a_texel() {
    const N: usize = 50_000;
    let level = sidak(ALPHA, 4);
    for (row, seed) in [(0, 5), (1, 6), (2, 7), (4, 8)] {
        // All but one texel are black.
        let s = surroundings(6, 5, "", |x, y| [f32::from((x, y) == (2, row)); 3]);
        let s = Surroundings::<f32>::new(&s);
        let mut random = Random(seed);
        let (mut uniform, mut by_theta) = (vec![0; 64], vec![0; 64]);
        for _ in 0..N {
            let u = [random.unit(), random.unit()].map(|u| u as f32);
            let d = surroundings_light_sample(&s, u).wi.f64().normalize();
            let [x, y] = place(d);
            let [upper, lower] = [row, row + 1].map(|edge| theta(edge, 5).cos());
            let eighth = |part: f64| (part * 8.0).clamp(0.0, 7.0) as usize;
            let across = eighth(x * 6.0 - 2.0);
            uniform[8 * eighth((upper - d.z) / (upper - lower)) + across] += 1;
            by_theta[8 * eighth(y * 5.0 - f64::from(row)) + across] += 1;
        }
        let expected = vec![N as f64 / 64.0; 64];
        let p = chi_square(&uniform, &expected);
        assert!(p > level, "row {row}: p = {p:e}");
        // In θ they are not, but about the equator, where that is nearly the same.
        assert!(row == 2 || chi_square(&by_theta, &expected) < level);
    }
}

/// At the ends of the numbers and of the picture, and in the first and last of many rows, where cos θ is 1 to f32.
#[test]
fn directions_stay_in_their_texels() {
    for (width, height) in [(1, 1), (3, 8192), (16, 8), (5, 3)] {
        let s = Surroundings::<f32>::new(&surroundings(width, height, "", |_, _| [1.0; 3]));
        for row in [0, height / 2, height - 1] {
            for (a, b) in [(0.0, 0.0), (0.5, 0.5), (0.25, 0.75), (1.0, 1.0)] {
                let d = surroundings_direction(&s, row, width - 1, a, b)
                    .f64()
                    .normalize();
                let sine = d.truncate().length();
                let angle = sine.atan2(d.z);
                let [upper, lower] = [row, row + 1].map(|edge| theta(edge, height));
                // Of h and r some 2⁻²⁴ each relative to sin θ, of z one of 1.
                let rounding = 1e-6 * sine;
                assert!(
                    angle >= upper - rounding && angle <= lower + rounding,
                    "{row}: {angle}"
                );
            }
        }
        for u in [[0.0, 0.0], [LAST, LAST], [0.0, LAST], [LAST, 0.5]] {
            let sample = surroundings_light_sample(&s, u.map(|u| u as f32));
            assert!(sample.pdf > 0.0 && sample.prim < width * height);
        }
    }
}

#[test]
fn a_black_picture_is_no_light() {
    let picture = picture(4, 2, |_, _| [0.0; 3]);
    let text = format!("screen 4 3\ncamera 0 0 0 1\n{}", background(&picture, ""));
    let prepared = prepared(&text, &Settings::default());
    assert!(prepared.lights.is_empty() && prepared.surroundings.is_none());
    assert!(prepared.warnings[0].contains("the scene has no lights"));
}
