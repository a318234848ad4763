//! Where f32 ends: throughput that underflows ends its path, a broken value breaks its sample, which is dropped, each is
//! counted by its cause; and events rarer than a uniform number can represent are right on average.

use vkpt::kernel::{OwnFile, file};
use vkpt::render::{Dropped, Job, KernelChoice, Outcome, Target};
use vkpt::settings::{Lights, Roulette, Settings};

use crate::common::render::{job, on_device, outcome, prepared};
use crate::common::settings::independent;

const SPP: u32 = 16;

fn without_roulette() -> Settings {
    let mut settings = Settings::default();
    settings.estimator.roulette = Roulette::Off;
    settings
}

/// The picture by cpu-f32 and by the device.
fn by_both(text: &str) -> Vec<Outcome> {
    let settings = without_roulette();
    let scene = prepared(text, &settings);
    let job = job(&scene, settings, SPP, 1);
    let reference = outcome(&job, &Target::CpuF32);
    [Some(reference), on_device(&job)]
        .into_iter()
        .flatten()
        .collect()
}

/// Between mirrors of Ks ½ throughput is 2⁻ᵏ after k bounces. 2⁻¹²⁶ can be stored, so a path dies at bounce 127.
#[test]
fn a_path_ends_where_its_throughput_underflows() {
    let mirrors = "screen 4 4\ncamera 0 0 .5 1e-9\nbackground 1 1 1\nbrdf 0 0 0 .5 .5 .5 0\n\
                   box -1 -1 -1 2 2 1\nbox -1 -1 1 2 2 1\n";
    for made in by_both(mirrors) {
        let stats = made.stats;
        assert_eq!(stats.underflows, stats.samples, "{}", stats.device);
        assert_eq!(stats.rays, 127 * stats.samples, "{}", stats.device);
        assert_eq!(stats.dropped, Dropped::default(), "{}", stats.device);
    }
}

/// A million units of glass of Kt 1e-6 transmit nothing, e^(−1.4e7): a path is reflected, F of them, and contributes 1, or
/// enters and is absorbed.
#[test]
fn a_path_that_is_absorbed_to_nothing_ends() {
    let slab = "screen 4 4\ncamera 0 0 1 1e-9\nbackground 1 1 1\nfresnel exact\n\
                brdf 0 0 0 .04 .04 .04 0 1e-6 1e-6 1e-6 1.5\nbox -2 -2 -1e6 4 4 1e6\n";
    for made in by_both(slab) {
        let stats = made.stats;
        let reflected: f32 = made.film.rgb.iter().map(|p| p[0] * SPP as f32).sum();
        assert_eq!(
            stats.underflows,
            stats.samples - reflected as u64,
            "{}",
            stats.device
        );
        assert!(0 < stats.underflows && stats.underflows < stats.samples);
    }
}

/// Red light on a green wall is black, and no underflow.
#[test]
fn a_colour_that_takes_all_light_is_no_underflow() {
    let room = "screen 4 4\ncamera 0 0 .5 1e-9\nbackground 1 1 1\nbrdf 0 0 0 1 0 0 0\nbox -1 -1 -1 2 2 1\n\
                brdf 0 0 0 0 1 0 0\nbox -1 -1 1 2 2 1\n";
    for made in by_both(room) {
        assert_eq!(made.stats.underflows, 0, "{}", made.stats.device);
        assert_eq!(
            made.stats.rays,
            2 * made.stats.samples,
            "{}",
            made.stats.device
        );
    }
}

/// A sky of 2⁹⁶ or more is dropped, because the sum of its samples may be infinite; radiance below is added up.
#[test]
fn samples_whose_sum_may_overflow_are_dropped() {
    for (sky, kept) in [("7.9e28", true), ("7.93e28", false), ("3e38", false)] {
        let text = format!("screen 4 4\ncamera 0 0 .5 1\nbackground {sky} 1 1\n");
        for made in by_both(&text) {
            let stats = &made.stats;
            let infinite = if kept { 0 } else { stats.samples };
            assert_eq!(
                stats.dropped,
                Dropped {
                    infinite,
                    ..Dropped::default()
                },
                "{sky} on {}",
                stats.device
            );
            let red: f32 = if kept {
                sky.parse().expect("a number")
            } else {
                0.0
            };
            assert!(
                made.film.rgb.iter().all(|p| p[0] == red),
                "{sky}: {:?}",
                made.film.rgb[0]
            );
        }
    }
}

/// A plate of glass, and one of metal, that fill the view.
const GLASS: &str = "brdf 0 0 0 .04 .04 .04";
const PLATE: &str = "box -2 -2 -1 4 4 1\n";

fn plate(material: &str) -> String {
    format!("screen 4 4\ncamera 0 0 1 1e-9\nbackground 1 1 1\nfresnel exact\n{material}\n{PLATE}")
}

/// A picture by a kernel whose file `name` has `wrong` instead of `right`.
fn planted(
    scene: &str,
    settings: Settings,
    name: &'static str,
    [right, wrong]: [&str; 2],
) -> Option<Outcome> {
    let honest = file(name).expect("a shader");
    assert_eq!(honest.matches(right).count(), 1, "the place to plant in");
    let text = honest.replace(right, wrong);
    let files = [OwnFile { name, text: &text }];
    let scene = prepared(scene, &settings);
    on_device(&Job {
        kernel: KernelChoice::Own(&files),
        ..job(&scene, settings, SPP, 1)
    })
}

/// Each sample meets the fault at its first vertex, where all directions that are drawn lead somewhere: all are counted,
/// and the picture is black.
#[test]
fn broken_samples_are_counted_by_cause_wherever_they_arise() {
    let smooth = format!("{GLASS} 0 1 1 1 1.5");
    let rough = format!("{GLASS} .01 1 1 1 1.5");
    let metal = "brdf 0 0 0 .9 .9 .9 .01";
    let chalk = "brdf .5 .5 .5 0 0 0 1";
    let lit = "light 1 1 1\nsphere 0 0 9 1\nbrdf .5 .5 .5 0 0 0 1";
    let fresnel = ["vec3(r <= 0.0 ? 1.0 : f)", "vec3(sqrt(-1.0 - f))"];
    let d = ["m.z > 0.0 ? d : 0.0", "sqrt(-1.0 - d)"];
    let light = ["expected * l.pdf", "sqrt(-1.0 - l.pdf)"];
    let kd = [
        "at.material.kd * pdf",
        "at.material.kd * (1e38 * (9.0 + pdf))",
    ];
    let ggx = "bsdf/distribution/ggx";
    let cases = [
        (smooth.as_str(), "bsdf/fresnel/exact", fresnel),
        (rough.as_str(), "bsdf/fresnel/exact", fresnel),
        (rough.as_str(), ggx, d),
        (metal, ggx, d),
        (lit, "integrator/path/pick/candidate", light),
        (chalk, "bsdf/diffuse/lambert", kd),
    ];
    // Of two broken candidates the one that is kept may lead to where the other hides it.
    let mut settings = Settings::default();
    settings.estimator.lights = Lights::Power;
    for (material, name, change) in cases {
        let made = planted(&plate(material), settings, name, change);
        let Some(made) = made else { return };
        let samples = made.stats.samples;
        let infinite = if material == chalk { samples } else { 0 };
        let expected = Dropped {
            nan: samples - infinite,
            infinite,
            loops: 0,
        };
        assert_eq!(made.stats.dropped, expected, "{material}: {change:?}");
        assert!(made.film.rgb.iter().flatten().all(|&x| x == 0.0));
    }
}

/// Glass of n = 1 + 2e-6 reflects F = ((n − 1)/(n + 1))² = 1e-12 of the light. All random numbers being 0, the least of
/// 2²⁴, each sample is reflected: that represents 2⁻²⁴ of them all, so one contributes F·2²⁴ of the sky.
#[test]
fn rare_events_contribute_their_mean() {
    let settings = independent();
    let glass = format!("{GLASS} 0 1 1 1 1.000002");
    let change = [
        "return pcg4d(uvec4(pixel, sample_index, block, seed));",
        "return uvec4(0u);",
    ];
    let made = planted(&plate(&glass), settings, "sampler/random", change);
    let Some(made) = made else { return };
    let n: f64 = 1.000002;
    let expected = ((n - 1.0) / (n + 1.0)).powi(2) * 2f64.powi(24);
    // A path of some 20 roundings; F is the square of the material's value in f32.
    let bound = 64.0 * expected * 2f64.powi(-24);
    for x in made.film.rgb.iter().flatten() {
        assert!(
            (f64::from(*x) - expected).abs() < bound,
            "{x:e}, not {expected:e}"
        );
    }
}
