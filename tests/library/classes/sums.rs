//! Classes that contain every path once add up to the picture, except for rounding.
//!
//! A pixel's sample adds c contributions ≥ 0 in f32, one after the other: relative error (c − 1) u, u = 2⁻²⁴. What follows errs
//! by 3 u at most: the sum of a sample's splats, which is kept in two parts and read as one; the mean, a quotient; the rounding
//! of each class's mean. Sums of samples, in two parts, and those of classes, in f64, err by less than 2⁻⁴⁰; u more covers
//! that and products of errors: (c + 3) u in all.

use std::sync::atomic::AtomicBool;

use vkpt::layout::constants::bidirectional::KEPT;
use vkpt::render::{Job, Target, light_classes};
use vkpt::settings::Integrator;

use super::{INTEGRATORS, classes, settings, split};
use crate::common::render::{job, outcome, prepared};

/// All that a surface may do: a floor with Kd and a sheen, a wall of Kd, rough and smooth glass, rough metal, a mirror with some
/// Kd; two lights and a background.
const SCENE: &str = "screen 24 18
camera 0 -6 3 .35 x 65
background .1 .2 .3
light 6 5 4
sphere 0 0 4 1
light 2 3 4
box -2 2.5 1 .4 .1 .4
brdf .5 .4 .3 .2 .3 .2 .3
box -5 -5 -.1 10 10 .1
brdf .3 .5 .6 0 0 0 1
box -5 4 0 10 .1 5
distribution ggx
brdf 0 0 0 .04 .04 .04 .2 .9 .8 .7 1.5
sphere -1.6 0 .8 .6
brdf 0 0 0 .04 .04 .04 0 .9 .95 1 1.5
sphere 0 -1 .7 .6
brdf 0 0 0 .7 .6 .5 .1
box 1 -.5 .002 .8 .8 1.1
brdf .1 .2 .1 .6 .6 .6 0
cylinder 2.4 .5 0 0 0 1.5 .4
";

const DEPTH: u32 = 6;

/// Contributions to a sample, at most: at each vertex that an eye path comes to, a light that it hits, one that it is connected
/// to, and kept vertices of a light path; and the background. Splats are added apart.
fn contributions(integrator: Integrator) -> u32 {
    let vertices = DEPTH + 1;
    match integrator {
        Integrator::Path => 2 * vertices + 1,
        Integrator::Light => 1,
        Integrator::Bidirectional => (2 + KEPT) * vertices + 1,
    }
}

/// By the first surface, by the last, and by the side of the first: each has every path once.
const PARTITIONS: [[&str; 4]; 3] = [
    ["EL", "ED.*L", "EG.*L", "ES.*L"],
    ["EL", "E.*DL", "E.*GL", "E.*SL"],
    ["EL", "ER.*L", "E<TG>.*L", "E<TS>.*L"],
];

/// The largest difference from the picture, relative to the bound.
fn off(picture: &[[f32; 3]], classes: &[Vec<[f32; 3]>], integrator: Integrator) -> f64 {
    let allowed = f64::from(contributions(integrator) + 3) * 2f64.powi(-24);
    let pixel = |(i, rgb): (usize, &[f32; 3])| {
        (0..3).fold(0.0, |worst, c| {
            let sum: f64 = classes.iter().map(|class| f64::from(class[i][c])).sum();
            let whole = f64::from(rgb[c]);
            let difference = (sum - whole).abs();
            f64::max(worst, difference / (allowed * sum.max(whole)).max(1e-300))
        })
    };
    picture.iter().enumerate().map(pixel).fold(0.0, f64::max)
}

#[test]
fn classes_add_up_to_the_picture() {
    for integrator in INTEGRATORS {
        let settings = settings(integrator, Some(DEPTH));
        let scene = prepared(SCENE, &settings);
        let job = job(&scene, settings, 48, 3);
        let picture = outcome(&job, &Target::CpuF32).film.rgb;
        for patterns in PARTITIONS {
            let all = split(&job, &patterns);
            let worst = off(&picture, &all, integrator);
            assert!(worst <= 1.0, "{integrator:?}, {patterns:?}: {worst}");
            for (i, pattern) in patterns.iter().enumerate() {
                // Light tracing shows neither mirrors nor surfaces behind glass, and nothing lies between lights and the eye.
                let is_dark = all[i].iter().flatten().all(|&x| x == 0.0);
                let smooth = ["ES.*L", "E<TS>.*L"].contains(pattern);
                let unseen = integrator == Integrator::Light && smooth;
                assert_eq!(is_dark, unseen, "{integrator:?}, {pattern}");
                if is_dark {
                    continue;
                }
                // One that is missing is noticed, and so is one that occurs twice.
                let mut without = all.clone();
                without.remove(i);
                assert!(off(&picture, &without, integrator) > 1e3, "{pattern}");
                let twice = [&all[..], &all[i..=i]].concat();
                assert!(off(&picture, &twice, integrator) > 1e3, "{pattern}");
            }
            // One letter for another.
            let wrong = patterns.map(|p| if p.contains('G') { "EDDL" } else { p });
            let wrong = split(&job, &wrong);
            assert!(off(&picture, &wrong, integrator) > 1e3, "{patterns:?}");
        }
    }
}

/// A crop has the pixels of the whole picture, to the bit, and the same with other classes next to it.
#[test]
fn classes_depend_neither_on_the_crop_nor_on_one_another() {
    for integrator in INTEGRATORS {
        let settings = settings(integrator, None);
        let scene = prepared(SCENE, &settings);
        let whole = job(&scene, settings, 3, 3);
        let crop = Job {
            crop: Some([5, 4, 19, 11]),
            ..whole
        };
        let all = split(&whole, &["ED.*L", "E.*S.*L"]);
        let part = split(&crop, &["E.*S.*L"]);
        let rows = all[1].chunks(24).skip(4).take(7);
        let expected: Vec<[f32; 3]> = rows.flat_map(|row| row[5..19].to_vec()).collect();
        assert_eq!(part[0], expected, "{integrator:?}");
    }
}

/// Radiance above 2⁹⁶ breaks the samples that see it: the film counts them as 0, and so does every class.
#[test]
fn samples_that_the_film_drops_are_dropped_from_every_class() {
    let scene = SCENE.replace("light 2 3 4", "light 2 1e30 4");
    for integrator in INTEGRATORS {
        let settings = settings(integrator, Some(DEPTH));
        let scene = prepared(&scene, &settings);
        let job = job(&scene, settings, 16, 3);
        let outcome = outcome(&job, &Target::CpuF32);
        assert!(outcome.stats.dropped.infinite > 0);
        let all = split(&job, &PARTITIONS[0]);
        let worst = off(&outcome.film.rgb, &all, integrator);
        assert!(worst <= 1.0, "{integrator:?}: {worst}");
        // Other samples stay.
        assert!(all[1].iter().flatten().any(|&x| x > 0.0));
    }
}

#[test]
fn who_stops_it_gets_none() {
    let settings = settings(Integrator::Path, None);
    let scene = prepared(SCENE, &settings);
    let job = job(&scene, settings, 4, 3);
    let stop = AtomicBool::new(true);
    // Nothing is requested, so nothing is left to do.
    let channels = light_classes(&job, 4, &stop, &mut |_| {});
    assert_eq!(channels, Some(Vec::new()));
    let classes = classes(&["EL"]);
    let job = Job {
        classes: &classes,
        ..job
    };
    assert_eq!(light_classes(&job, 4, &stop, &mut |_| {}), None);
    // Each step is reported to the end.
    let mut reported = Vec::new();
    light_classes(&job, 4, &AtomicBool::new(false), &mut |p| reported.push(p));
    assert_eq!(
        reported.last().map(|p| (p.samples_done, p.fraction)),
        Some((4, 1.0))
    );
}
