//! Bidirectional pictures have the mean of path tracing's, all ways together and each alone, by the reference in f32.
//!
//! Block means of pictures by several seeds are compared by Welch's t-test, as `light_tracing` has it: Šidák over all blocks,
//! scenes and settings at α = 1e-3; fixed seeds.

use vkpt::film::Film;
use vkpt::reference::integrator::bidirectional::record::Silent;
use vkpt::reference::integrator::bidirectional::{Transport, Ways, trace_bidirectional};
use vkpt::reference::integrator::light::Splat;
use vkpt::reference::world::World;
use vkpt::render::{Job, Target};
use vkpt::settings::{Integrator, Lights, Roulette, Sampler, Settings};

use super::{samples, whole};
use crate::common::meshes::cube;
use crate::common::render::{job, outcome, prepared};
use crate::common::scenes::{FLUSH, INSIDE, MANY, SMOOTH, TABLE, WIDE};
use crate::common::stats::sidak;
use crate::estimators::{Effort, MEANS, block_means, means, relative_error};
use crate::light_tracing::{lamps, least_p};

const ALPHA: f64 = 1e-3;

fn both(mut settings: Settings) -> Settings {
    settings.estimator.integrator = Integrator::Bidirectional;
    settings
}

/// A sharp lobe next to a diffuse one, α = .002, and a sphere of glass hardly rougher than smooth.
const SHARP: &str = "screen 32 24
camera 0 -6 3 .35 x 64
light 6 5 4
sphere -1.5 1 3.2 .8
brdf .5 .5 .4 0 0 0 1
box -5 -5 -.1 10 10 .1
distribution ggx
brdf .2 .1 .1 .5 .6 .6 .002
box 1 -1 0 1 2 1.5
brdf 0 0 0 .04 .04 .04 .002 .9 .9 .8 1.5
sphere -.6 -.8 .6 .6
";

/// The defaults, and each setting that affects both kinds of paths.
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
        ("max-depth 3", with(|s| s.model.max_depth = Some(3))),
        (
            "roulette 0.8",
            with(|s| s.estimator.roulette = Roulette::Constant(0.8)),
        ),
        (
            "random numbers, lights by power",
            with(|s| {
                s.estimator.sampler = Sampler::Random;
                s.estimator.lights = Lights::Power;
            }),
        ),
    ]
}

fn agree(effort: Effort) {
    let cube = cube();
    let scenes = [
        ("table", TABLE.to_owned()),
        ("smooth", SMOOTH.to_owned()),
        ("wide", WIDE.to_owned()),
        ("flush", FLUSH.to_owned()),
        ("many", MANY.to_owned()),
        ("lamps", lamps(cube.path())),
        ("inside", INSIDE.to_owned()),
        ("sharp", SHARP.to_owned()),
    ];
    let level = sidak(ALPHA, scenes.len() * variants().len() * MEANS);
    let (mut least, mut error) = (1.0, 0.0_f64);
    for (s, (scene, text)) in scenes.iter().enumerate() {
        for (k, (name, settings)) in variants().into_iter().enumerate() {
            let seed = (1000 * (20 * s + 2 * k)) as u32;
            let scene_for = prepared(text, &settings);
            let paths = means(&scene_for, settings, effort, seed);
            let found = means(&scene_for, both(settings), effort, seed + 1000);
            let p = least_p(&paths, &found);
            assert!(p > level, "{scene}, {name}: p = {p:e}");
            least = f64::min(least, p);
            error = error
                .max(relative_error(&paths))
                .max(relative_error(&found));
        }
    }
    println!("least p-value {least:.1e}, level {level:.1e}, largest standard error {error:.1e}");
}

#[test]
fn all_ways_together_have_the_mean_of_path_tracing() {
    agree(Effort { seeds: 16, spp: 24 });
}

/// Light paths of the whole picture are followed, whichever crop is rendered.
#[test]
fn a_crop_has_the_bits_of_the_whole() {
    let settings = both(Settings::default());
    for text in [TABLE, SMOOTH, WIDE] {
        let scene = prepared(text, &settings);
        let whole = job(&scene, settings, 6, 3);
        let [left, top, right, bottom] = [5, 3, 22, 20];
        let crop = Job {
            crop: Some([left, top, right, bottom]),
            ..job(&scene, settings, 6, 3)
        };
        let film = |job: &Job| outcome(job, &Target::CpuF32).film;
        let (whole, part) = (film(&whole), film(&crop));
        let bits =
            |film: &Film, x: u32, y: u32| film.rgb[(y * film.width + x) as usize].map(f32::to_bits);
        for y in top..bottom {
            for x in left..right {
                let there = bits(&part, x - left, y - top);
                assert_eq!(there, bits(&whole, x, y), "{x}, {y}");
            }
        }
    }
}

#[test]
#[ignore = "up to an hour"]
fn all_ways_together_have_the_mean_of_path_tracing_to_a_thousandth() {
    agree(Effort::LONG);
}

/// Block means of pictures by some ways, seed by seed; light paths scatter by `adjoint`.
fn by_ways(
    text: &str,
    settings: &Settings,
    adjoint: &Settings,
    ways: Ways,
    effort: Effort,
) -> Vec<Vec<f64>> {
    let prepared = prepared(text, settings);
    let world = World::<f32>::new(&prepared);
    let transport = Transport {
        world: &world,
        settings,
        adjoint,
        ways,
    };
    let window = whole(&prepared);
    let mut all = vec![Vec::new(); MEANS];
    for seed in 5000..5000 + effort.seeds {
        let mut pixels = vec![0.0; (window.width * window.height) as usize];
        for id in samples(&prepared, effort.spp, seed) {
            let mut add = |Splat { value: v, pixel }| {
                let sum = f64::from(v.x) + f64::from(v.y) + f64::from(v.z);
                pixels[pixel as usize] += sum / 3.0 / f64::from(effort.spp);
            };
            let (radiance, _) = trace_bidirectional(transport, window, id, &mut Silent, &mut add);
            let pixel = id.pixel;
            radiance
                .into_iter()
                .for_each(|value| add(Splat { value, pixel }));
        }
        for (all, mean) in all.iter_mut().zip(block_means(&pixels)) {
            all.push(mean);
        }
    }
    all
}

/// The light that path tracing finds with exactly `depth` scatterings: two pictures by the same seeds, one less the other.
fn of_depth(text: &str, depth: u32, effort: Effort) -> Vec<Vec<f64>> {
    let up_to = |n: u32| {
        let mut settings = Settings::default();
        settings.model.max_depth = Some(n);
        means(&prepared(text, &settings), settings, effort, 9000)
    };
    let (with, without) = (up_to(depth), up_to(depth - 1));
    let blocks = with.iter().zip(&without);
    blocks
        .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a - b).collect())
        .collect()
}

/// Paths of two and of three scatterings by every number of light vertices, without weights, where each can find all of them:
/// all surfaces are rough, and the light emits from its outside only.
#[test]
fn each_way_alone_has_the_mean_of_path_tracing() {
    let cube = cube();
    let effort = Effort {
        seeds: 16,
        spp: 192,
    };
    let level = sidak(ALPHA, 2 * (4 + 5) * MEANS);
    for (name, text) in [("inside", INSIDE.to_owned()), ("lamps", lamps(cube.path()))] {
        for depth in [2, 3] {
            let right = of_depth(&text, depth, effort);
            for light in 0..=depth + 1 {
                let ways = Ways::Only {
                    light,
                    eye: depth + 2 - light,
                };
                let mut settings = Settings::default();
                settings.model.max_depth = Some(depth);
                let found = by_ways(&text, &settings, &settings.adjoint(), ways, effort);
                let p = least_p(&right, &found);
                println!("{name}, {ways:?}: p = {p:.1e}");
                assert!(p > level, "{name}, {ways:?}: p = {p:e}");
            }
        }
    }
}

/// Refraction on light paths by the rule of eye paths: n² more or less than there is.
#[test]
fn eta_squared_on_the_wrong_side_is_noticed() {
    let effort = Effort { seeds: 16, spp: 64 };
    let level = sidak(ALPHA, MEANS);
    let settings = Settings::default();
    let right = by_ways(INSIDE, &settings, &settings.adjoint(), Ways::All, effort);
    let wrong = by_ways(INSIDE, &settings, &settings, Ways::All, effort);
    let p = least_p(&right, &wrong);
    println!("p = {p:.1e}");
    assert!(p < level, "p = {p:e}");
}
