//! Nothing is made, smooth surfaces lose nothing, no length is special (model.md, "Energy").
//!
//! Whole renderings by the reference in f32, which a CPU driver equals bit for bit (`tests/device/same_bits.rs`).

use vkpt::film::Film;
use vkpt::render::Target;
use vkpt::settings::{Distribution, DistributionRule, Settings};

use crate::common::meshes::cube;
use crate::common::render::{difference, film, pixel_means};
use crate::common::stats::{mean_and_error, p_of_difference, p_of_mean, sidak};

const ALPHA: f64 = 1e-3;
/// Of some dozen factors in f32.
const ROUNDING: f64 = 1e-5;
/// How far Beckmann's rational G1 may be off (model.md, "Energy").
const RATIONAL_G1: f64 = 3.2e-3;

fn render(text: &str, settings: Settings, spp: u32, seed: u32) -> Film {
    film(text, settings, spp, seed, &Target::CpuF32)
}

/// Every kind of shape, about as large as a ball of radius `s`; `cube` is the file of a mesh.
fn shapes(cube: &str, s: f64) -> [String; 4] {
    let [half, quarter] = [s / 2.0, s / 4.0];
    [
        format!("sphere 0 0 0 {s}"),
        format!("box -{half} -{half} -{half} {s} {s} {s}"),
        format!("cylinder 0 -{half} -{quarter} 0 {s} {half} {half}"),
        format!("mesh {cube} 0 0 0 {half} x 30 y 20"),
    ]
}

/// A shape in a world of radiance 1, seen from 3 · s away.
fn furnace(shape: &str, brdf: &str, s: f64) -> String {
    let (sin_x, cos_x) = 65f64.to_radians().sin_cos();
    let (sin_z, cos_z) = 25f64.to_radians().sin_cos();
    let eye = [sin_x * sin_z, -sin_x * cos_z, cos_x].map(|x| 3.0 * s * x);
    format!(
        "screen 16 16\ncamera {} {} {} .35 z 25 x 65\nbackground 1 1 1\n{brdf}\n{shape}\n",
        eye[0], eye[1], eye[2]
    )
}

/// Each sample of smooth glass that absorbs nothing brings back 1, from every kind of shape and at any scale.
#[test]
fn smooth_glass_vanishes_in_a_furnace() {
    let cube = cube();
    for scale in [1e-4, 1.0, 1e4] {
        for shape in shapes(&cube.path().display().to_string(), scale) {
            for fresnel in ["exact", "schlick"] {
                let glass = format!("fresnel {fresnel}\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5");
                let film = render(&furnace(&shape, &glass, scale), Settings::default(), 16, 1);
                let worst = film
                    .rgb
                    .iter()
                    .flatten()
                    .map(|&x| (f64::from(x) - 1.0).abs());
                let worst = worst.fold(0.0, f64::max);
                assert!(worst < ROUNDING, "{shape}, {fresnel}: off by {worst:e}");
            }
        }
    }
}

/// Rough glass loses light, and how much does not depend on its size: a factor of 2¹³ leaves every bit, one of 10⁴
/// the mean.
#[test]
fn no_length_is_special() {
    let cube = cube();
    let file = cube.path().display().to_string();
    let glass = "fresnel exact\nbrdf 0 0 0 .04 .04 .04 .3 1 1 1 1.5";
    let picture = |kind: usize, scale: f64, seed: u32| {
        let shape = &shapes(&file, scale)[kind];
        render(&furnace(shape, glass, scale), Settings::default(), 64, seed)
    };
    let means = |kind: usize, scale: f64, seed: u32| -> Vec<f64> {
        let mean = |k| mean_and_error(&pixel_means(&picture(kind, scale, seed + k))).0;
        (0..24).map(mean).collect()
    };
    let level = sidak(ALPHA, 4 * 2);
    for kind in 0..4 {
        let one = picture(kind, 1.0, 1);
        for scale in [2f64.powi(-13), 2f64.powi(13)] {
            assert_eq!(
                difference(&one, &picture(kind, scale, 1)),
                None,
                "{kind} × {scale}"
            );
        }
        let ones = means(kind, 1.0, 100);
        for (k, scale) in [1e-4, 1e4].into_iter().enumerate() {
            let others = means(kind, scale, 200 + 100 * k as u32);
            let p = p_of_difference(&ones, &others);
            assert!(p > level, "shape {kind} × {scale}: p = {p:e}");
            let planted: Vec<f64> = others.iter().map(|x| 1.01 * x).collect();
            let p = p_of_difference(&ones, &planted);
            assert!(p < level, "shape {kind} × {scale}, 1 % brighter: p = {p:e}");
        }
    }
}

/// A camera that sees one point of the interface z = 0 of a wide slab of glass, at `cos` to its normal, from outside
/// or from within. What is transmitted and what is reflected both end in radiance 1: the picture is R + T.
fn interface(outside: bool, cos: f64, alpha: f64, ior: f64) -> String {
    let degrees = cos.acos().to_degrees();
    let sin = (1.0 - cos * cos).sqrt();
    let (eye, turn) = match outside {
        true => (format!("0 {} {cos}", -sin), degrees),
        false => (
            format!("0 {} {}", -0.01 * sin, -0.01 * cos),
            180.0 - degrees,
        ),
    };
    // Within the glass a black body shines; from inside the camera stands between it and the interface.
    format!(
        "screen 16 16\ncamera {eye} 1e-6 x {turn}\nbackground 1 1 1\n\
         light 1 1 1\nbox -90 -90 -1 180 180 .98\nfresnel exact\n\
         brdf 0 0 0 .04 .04 .04 {alpha} 1 1 1 {ior}\nbox -100 -100 -2 200 200 2\n"
    )
}

/// Without radiance scaling, which would make 1 in the glass count as 1/n² outside.
fn unscaled(distribution: Distribution) -> Settings {
    let mut settings = Settings::default();
    settings.model.radiance_scaling = false;
    settings.model.distribution = DistributionRule::Always(distribution);
    settings
}

#[test]
fn a_smooth_interface_loses_nothing() {
    for outside in [true, false] {
        for ior in [1.1, 1.5, 2.5, 1.0 / 1.5] {
            for cos in [0.05, 0.3, 0.6, 1.0] {
                let scene = interface(outside, cos, 0.0, ior);
                let film = render(&scene, unscaled(Distribution::Ggx), 4, 1);
                for &x in film.rgb.iter().flatten() {
                    let off = (f64::from(x) - 1.0).abs();
                    assert!(
                        off < ROUNDING,
                        "ior {ior}, cos {cos}, outside {outside}: off by {off:e}"
                    );
                }
            }
        }
    }
}

/// One-sided: the mean is above `bound` with this p-value.
fn p_above(samples: &[f64], bound: f64) -> f64 {
    if mean_and_error(samples).0 <= bound {
        1.0
    } else {
        p_of_mean(samples, bound, ROUNDING) / 2.0
    }
}

#[test]
fn a_rough_interface_makes_nothing() {
    let cases = || {
        let distributions = [Distribution::Ggx, Distribution::Beckmann];
        distributions.into_iter().flat_map(|distribution| {
            [0.05, 0.2, 0.5, 1.0].into_iter().flat_map(move |alpha| {
                [1.1, 1.5, 2.5, 1.0 / 1.5].into_iter().flat_map(move |ior| {
                    [true, false].into_iter().flat_map(move |outside| {
                        [0.1, 0.5, 1.0].map(|cos| (distribution, alpha, ior, outside, cos))
                    })
                })
            })
        })
    };
    let level = sidak(ALPHA, cases().count());
    let mut caught = 0;
    for (distribution, alpha, ior, outside, cos) in cases() {
        let scene = interface(outside, cos, alpha, ior);
        let pixels = pixel_means(&render(&scene, unscaled(distribution), 64, 1));
        let p = p_above(&pixels, 1.0 + RATIONAL_G1);
        assert!(
            p > level,
            "{distribution:?}, alpha {alpha}, ior {ior}, cos {cos}, outside {outside}: {:?}, p = {p:e}",
            mean_and_error(&pixels)
        );
        let planted: Vec<f64> = pixels.iter().map(|x| 1.01 * x).collect();
        caught += usize::from(p_above(&planted, 1.0 + RATIONAL_G1) < level);
    }
    assert!(caught > 0, "1 % too much must be noticed");
}

/// The sums of `albedo_dielectric.csv`, through the whole renderer.
#[test]
fn a_rough_interface_loses_what_quadrature_says() {
    let path = "../shared/spec/tables/albedo_dielectric.csv";
    let Ok(table) = std::fs::read_to_string(path) else {
        println!("skipped: {path} is not there");
        return;
    };
    let rows: Vec<Vec<&str>> = table
        .lines()
        .skip(1)
        .map(|l| l.split(',').collect())
        .collect();
    let level = sidak(ALPHA, rows.len());
    let mut caught = 0;
    for row in &rows {
        let distribution = match row[0] {
            "ggx" => Distribution::Ggx,
            "beckmann" => Distribution::Beckmann,
            "phong" => Distribution::Phong,
            _ => continue,
        };
        let number = |i: usize| row[i].parse::<f64>().expect("a number");
        let scene = interface(row[4] == "outside", number(5), number(2), number(3));
        let pixels = pixel_means(&render(&scene, unscaled(distribution), 64, 2));
        let p = p_of_mean(&pixels, number(8), ROUNDING);
        assert!(
            p > level,
            "{row:?}: {:?}, p = {p:e}",
            mean_and_error(&pixels)
        );
        caught += usize::from(p_of_mean(&pixels, 1.01 * number(8), ROUNDING) < level);
    }
    assert!(caught > 0, "an error of 1 % must be noticed");
}
