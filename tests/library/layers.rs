//! Layers next to a picture, by closed forms: planes, balls, the views in a mirror and through a pane of glass.

use glam::DVec3;
use vkpt::film::{Aov, Channel};
use vkpt::render::{Job, layer_samples, layers};
use vkpt::settings::Settings;

use crate::common::render::{job, prepared};
use crate::common::stats::{mean_and_error, p_of_mean, sidak};

const ALPHA: f64 = 1e-3;
const ALL: [Aov; 9] = [
    Aov::Albedo,
    Aov::Normal,
    Aov::Depth,
    Aov::Position,
    Aov::Shape,
    Aov::Material,
    Aov::Samples,
    Aov::AlbedoBehind,
    Aov::NormalBehind,
];

/// All layers of a picture of so many samples.
fn seen(scene: &str, spp: u32) -> Vec<Channel> {
    let settings = Settings::default();
    let prepared = prepared(scene, &settings);
    let job = Job {
        aovs: &ALL,
        ..job(&prepared, settings, spp, 1)
    };
    layers(&job, spp)
}

/// The values of a channel.
fn values<'a>(channels: &'a [Channel], name: &str) -> &'a [f32] {
    let channel = channels.iter().find(|channel| channel.name == name);
    &channel.unwrap_or_else(|| panic!("{name}")).values
}

/// The pixel's values of three channels.
fn xyz(channels: &[Channel], layer: &str, i: usize) -> DVec3 {
    let [x, y, z] = ["X", "Y", "Z"].map(|end| values(channels, &format!("{layer}.{end}"))[i]);
    DVec3::new(x.into(), y.into(), z.into())
}

fn rgb(channels: &[Channel], layer: &str, i: usize) -> [f32; 3] {
    ["R", "G", "B"].map(|end| values(channels, &format!("{layer}.{end}"))[i])
}

/// A wall 4 away, seen straight on: depth and normal are the same everywhere, the place is within the pixel.
#[test]
fn a_wall_is_where_it_is() {
    let scene =
        "screen 8 6\ncamera 1 2 5 .5\nbrdf .5 .25 .125 .1 .1 .1 10\n\nbox -50 -50 0 100 100 1\n";
    let channels = seen(scene, 100);
    for i in 0..48 {
        assert!((f64::from(values(&channels, "Z")[i]) - 4.0).abs() < 1e-5);
        for layer in ["N", "Ns", "NsBehind"] {
            assert_eq!(xyz(&channels, layer, i), DVec3::Z, "{layer}");
        }
        for layer in ["Albedo", "AlbedoBehind"] {
            let off = |(a, b): (f32, f32)| (a - b).abs() < 1e-6;
            let expected = [0.6, 0.35, 0.225];
            assert!(rgb(&channels, layer, i).into_iter().zip(expected).all(off));
        }
        assert_eq!(values(&channels, "Shape.Line")[i], 5.0);
        assert_eq!(values(&channels, "Material.Line")[i], 3.0);
        assert_eq!(values(&channels, "Samples.N")[i], 100.0);
        // Pixels are 4/6 wide there: 2 ry · 4/6.
        let (column, row) = ((i % 8) as f64, (i / 8) as f64);
        let left = 1.0 + (column - 4.0) * 4.0 / 6.0;
        let upper = 2.0 + (3.0 - row) * 4.0 / 6.0;
        let p = xyz(&channels, "P", i);
        assert!(p.x > left && p.x < left + 4.0 / 6.0, "{i}: {p}");
        assert!(p.y < upper && p.y > upper - 4.0 / 6.0, "{i}: {p}");
        assert!((p.z - 1.0).abs() < 1e-5);
        // Their mean is about the middle: of 64 points of a net well within a tenth of the width.
        assert!((p.x - left - 2.0 / 6.0).abs() < 4.0 / 60.0);
    }
}

/// Of a ball every normal is (p − c)/r, and so is the mean of normals that of places.
#[test]
fn a_ball_has_the_normals_of_its_places() {
    let scene = "screen 16 12\ncamera 0 0 5 .1\nbrdf .5 .5 .5 0 0 0 1\nsphere .1 .2 -1 2\n";
    let channels = seen(scene, 64);
    let centre = DVec3::new(0.1, 0.2, -1.0);
    for i in 0..16 * 12 {
        let expected = (xyz(&channels, "P", i) - centre) / 2.0;
        for layer in ["N", "Ns"] {
            let found = xyz(&channels, layer, i);
            assert!(
                (found - expected).length() < 1e-5,
                "{layer}: {found}, {expected}"
            );
        }
        // Another centre is noticed.
        let moved = (xyz(&channels, "P", i) - centre - DVec3::X * 0.01) / 2.0;
        assert!((xyz(&channels, "N", i) - moved).length() > 1e-3);
    }
}

/// A wall behind the eye, in a mirror straight ahead: Ks times its albedo, and its normal.
#[test]
fn a_mirror_shows_the_surface_that_it_reflects() {
    let scene = "screen 4 3\ncamera 0 0 5 1e-6\nbrdf 0 0 0 .9 .8 .7 0\nbox -50 -50 0 100 100 1\n\
                 brdf .5 .25 .125 0 0 0 1\nbox -50 -50 9 100 100 1\n";
    let channels = seen(scene, 16);
    for i in 0..12 {
        let expected = [0.9 * 0.5, 0.8 * 0.25, 0.7 * 0.125];
        let behind = rgb(&channels, "AlbedoBehind", i);
        assert!(
            behind
                .into_iter()
                .zip(expected)
                .all(|(a, b)| (a - b).abs() < 1e-6),
            "{behind:?}"
        );
        assert!((xyz(&channels, "NsBehind", i) + DVec3::Z).length() < 1e-6);
        assert_eq!(xyz(&channels, "Ns", i), DVec3::Z);
        let own = rgb(&channels, "Albedo", i);
        assert!(
            own.into_iter()
                .zip([0.9, 0.8, 0.7])
                .all(|(a, b): (f32, f32)| (a - b).abs() < 1e-6)
        );
    }
}

/// A pane transmits (1 − F)/(1 + F), F = .04 from either side, and shows the wall behind; the light that it reflects is black.
#[test]
fn a_pane_shows_the_surface_behind_weighted_by_its_transmission() {
    let scene = "screen 64 48\ncamera 0 0 5 1e-6\nbrdf 0 0 0 .04 .04 .04 0 1 1 1 1.5\nbox -50 -50 0 100 100 1\n\
                 brdf .5 .5 .5 0 0 0 1\nbox -50 -50 -9 100 100 1\n";
    let channels = seen(scene, 16);
    let shown: Vec<f64> = values(&channels, "AlbedoBehind.R")
        .iter()
        .map(|&x| x.into())
        .collect();
    let expected = 0.5 * 0.96 / 1.04;
    let (mean, error) = mean_and_error(&shown);
    let p = p_of_mean(&shown, expected, 1e-6);
    assert!(p > sidak(ALPHA, 1), "{mean} ± {error}, expected {expected}");
    assert!(p_of_mean(&shown, 0.5, 1e-6) < ALPHA, "all of the light");
    let own = rgb(&channels, "Albedo", 0);
    assert_eq!(own, [1.0; 3]);
}

/// A light has its colour, the background its radiance up to 1; where nothing is, there is neither place nor line.
#[test]
fn lights_and_the_background_have_their_colours() {
    let scene = "screen 16 12\ncamera 0 0 9 .5\nbackground .25 .5 4\nlight 6 3 0\nsphere 0 0 0 1\n";
    let channels = seen(scene, 16);
    let middle = 6 * 16 + 8;
    assert_eq!(rgb(&channels, "Albedo", middle), [1.0, 0.5, 0.0]);
    assert_eq!(values(&channels, "Shape.Line")[middle], 5.0);
    for layer in ["Albedo", "AlbedoBehind"] {
        assert_eq!(rgb(&channels, layer, 0), [0.25, 0.5, 1.0]);
    }
    for name in ["Z", "P.X", "N.Z", "Shape.Line", "Material.Line"] {
        assert_eq!(values(&channels, name)[0], 0.0, "{name}");
    }
}

/// Layers have half of a picture's samples and 64 at most: more change only their number.
#[test]
fn layers_are_known_from_the_first_samples() {
    let scene = "screen 8 6\ncamera 0 0 5 .5\nbrdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1\n";
    let (all, more, few) = (seen(scene, 128), seen(scene, 1000), seen(scene, 8));
    for (a, b) in all.iter().zip(&more).filter(|(a, _)| a.name != "Samples.N") {
        assert_eq!(a, b);
    }
    assert_ne!(values(&all, "Z"), values(&few, "Z"));
    assert_eq!(values(&more, "Samples.N")[0], 1000.0);
    assert_eq!(
        [0, 1, 3, 4, 128, u32::MAX].map(layer_samples),
        [0, 1, 2, 2, 64, 64]
    );
}

/// Only the requested layers are there, each channel once, with any crop.
#[test]
fn only_requested_layers_are_there() {
    let scene = "screen 8 6\ncamera 0 0 5 .5\nbrdf .5 .5 .5 0 0 0 1\nsphere 0 0 0 1\n";
    let settings = Settings::default();
    let prepared = prepared(scene, &settings);
    let of = |aovs, crop| {
        let job = Job {
            aovs,
            crop,
            ..job(&prepared, settings, 8, 1)
        };
        layers(&job, 8)
    };
    assert_eq!(of(&[], None), []);
    assert_eq!(of(&[Aov::Stderr], None), []);
    let depths = of(&[Aov::Depth, Aov::Stderr, Aov::Depth], None);
    assert_eq!(depths.len(), 1);
    let crop = of(&[Aov::Depth], Some([2, 1, 7, 5]));
    let rows = depths[0].values.chunks(8).skip(1).take(4);
    let expected: Vec<f32> = rows.flat_map(|row| row[2..7].to_vec()).collect();
    assert_eq!(crop[0].values, expected);
}
