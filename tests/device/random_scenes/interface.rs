//! One interface of any material, with radiance 1 on both sides: it returns no more than it may.

use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;
use vkpt::prepared::{Material, Prepared};
use vkpt::settings::{Connect, Fresnel, LobeChoice, Normals, Roulette, Sampler, Settings};

use super::bound::{albedo, weight};
use super::case::Case;
use super::material::brdf;
use super::number::decades;
use super::samples::{By, COMPOSED, Made, made};
use super::settings::settings;
use super::{check_property, long_seeds};
use crate::common::stats::{mean_and_error, p_of_mean, sidak};

const FILE: &str = "tests/device/random_scenes/regressions/interface.txt";

/// A point of the interface z = 0 of a wide slab, seen from outside or from within.
#[derive(Clone, Debug)]
pub struct Interface {
    pub outside: bool,
    pub cos: f64,
    /// Radiance of the body within.
    pub inside: f64,
    pub case: Case,
}

/// tan of half the field of view: below the resolution of single precision, so that wo is one direction.
const RY: f64 = 1e-12;

/// Light that is transmitted, or reflected within, ends at a black body that emits below the interface; of n² where
/// radiance is scaled, which makes it 1 outside. Paths end at the light that they meet after the interface.
fn scene(outside: bool, cos: f64, brdf: &str, inside: f64) -> String {
    let degrees = cos.acos().to_degrees();
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    // Between the body and the interface, if not outside.
    let (eye, turn) = match outside {
        true => (format!("0 {} {cos}", -sin), degrees),
        false => (
            format!("0 {} {}", -0.01 * sin, -0.01 * cos),
            180.0 - degrees,
        ),
    };
    format!(
        "screen 8 8\ncamera {eye}  {RY}  x {turn}\nbackground 1 1 1\n\
         light {inside} {inside} {inside}\nbox -90 -90 -1  180 180 .98\n{brdf}\nbox -100 -100 -2  200 200 2\n"
    )
}

/// n² of the emitting body, within the range of radiances: beyond it radiance is not scaled.
const SCALED: std::ops::RangeInclusive<f64> = 1e-12..=1e12;

impl Interface {
    /// For the material of these lines, with the index of refraction as the last number.
    pub fn of(outside: bool, cos: f64, brdf: &str, mut settings: Settings, seed: u32) -> Self {
        let ior = brdf.rsplit(' ').next().and_then(|n| n.parse().ok());
        let n2 = ior.map_or(1.0, |n: f64| n * n);
        settings.model.max_depth = Some(1);
        settings.model.radiance_scaling &= SCALED.contains(&n2);
        // Statistics are made of independent samples.
        settings.estimator.sampler = Sampler::Random;
        let inside = if settings.model.radiance_scaling {
            n2
        } else {
            1.0
        };
        let text = scene(outside, cos, brdf, inside);
        Self {
            outside,
            cos,
            inside,
            case: Case {
                text,
                settings,
                seed,
            },
        }
    }
}

fn interface() -> impl Strategy<Value = Interface> {
    let cos = prop_oneof![Just(1.0), 1e-3..1.0f64, decades(-3.0, 0.0)];
    (any::<bool>(), cos, brdf(), settings(), any::<u32>()).prop_map(
        |(outside, cos, brdf, settings, seed)| Interface::of(outside, cos, &brdf, settings, seed),
    )
}

/// The interface's own, whose line is the scene's last but one.
fn material(prepared: &Prepared) -> &Material {
    &prepared.materials[prepared
        .shapes
        .iter()
        .max_by_key(|s| s.line)
        .map_or(0, |s| s.material as usize)]
}

/// The bound of the picture in each channel, and, by an estimator that bounds it, of a sample's mean.
pub struct Limits {
    pub mean: [f64; 3],
    pub sample: Option<f64>,
}

impl Interface {
    /// The limits; `None` if the eye is within an opaque slab.
    pub fn limits(&self, prepared: &Prepared) -> Option<Limits> {
        let m = material(prepared);
        if !self.outside && !Prepared::is_transmissive(m) {
            return None;
        }
        let radiance = if self.outside { 1.0 } else { self.inside };
        let e = &self.case.settings.estimator;
        // (1 − F)/(1 − F̄) has the mean 1 over RGB except for the digits that 1 − F̄ has lost, which may be all; grey loses
        // nothing.
        let grey = m.f0.x == m.f0.y && m.f0.y == m.f0.z;
        let exact = m.fresnel == Fresnel::Exact || grey || !Prepared::is_transmissive(m);
        // Where light is not connected to, a path contributes only its weight.
        let bounded = exact
            && e.connect == Connect::Bsdf
            && (e.lobe, e.normals) == (LobeChoice::Fresnel, Normals::Visible)
            && !matches!(e.roulette, Roulette::Constant(_));
        Some(Limits {
            mean: [0, 1, 2].map(|c| radiance * albedo(m, c, self.cos)),
            sample: bounded.then(|| radiance * weight(m, self.cos)),
        })
    }
}

/// Samples of each of the 64 pixels.
const SPP: u32 = 128;
const SAMPLES: f64 = 64.0 * SPP as f64;
/// Two vertices of 128 roundings each, as `vkpt check` counts them.
const ROUNDING: f64 = 2.0 * 128.0 / 16_777_216.0;
/// Below this single precision keeps fewer digits.
const DENORMAL: f64 = f32::MIN_POSITIVE as f64;
/// The effect of recomputing a micro-normal in f32 on D at the widths and contrasts that still have a density (model.md,
/// "Limits": 1e-8/(α|n − 1|) on the median, 6 times that at 99 %), at α|n − 1| = 1e-5.
const RECOMPUTED: f64 = 6e-3;

/// The values above their limits; each of the renderers' channels by a t-test of this level. Where single samples have a
/// long tail upwards, such a test rejects less often than it says. Downwards the tail is events that contribute nothing, of
/// which samples say nothing if none occurs: of probability p none does with (1 − p)ⁿ < e^(−pn), which is this level
/// at p = −ln(level)/n, and without them the mean is at most 1/(1 − p) of its true value.
pub fn excess(limits: &Limits, all: &[Made], settings: &Settings, level: f64) -> Option<String> {
    let rounding = match settings.estimator.connect {
        Connect::Bsdf => ROUNDING,
        Connect::Mis | Connect::Light => ROUNDING + RECOMPUTED,
    };
    let unseen = -level.ln() / SAMPLES;
    all.iter().find_map(|made| {
        let channels = (0..3).find_map(|c| {
            let pixels: Vec<f64> = made.pixels().iter().map(|p| p[c]).collect();
            let (mean, error) = mean_and_error(&pixels);
            let p = p_above(
                &pixels,
                limits.mean[c] * (1.0 + rounding) / (1.0 - unseen) + DENORMAL,
            );
            (p < level).then(|| {
                format!(
                    "{}: {mean} ± {error:.1e} in channel {c}, at most {}",
                    made.by, limits.mean[c]
                )
            })
        });
        channels.or_else(|| {
            let most = limits.sample?;
            let mean = |s: &[f64; 3]| (s[0] + s[1] + s[2]) / 3.0;
            let brightest = made.radiances.iter().map(mean).fold(0.0, f64::max);
            (brightest > most * (1.0 + ROUNDING) + DENORMAL)
                .then(|| format!("{}: a sample of {brightest}, at most {most}", made.by))
        })
    })
}

/// One-sided: the mean is above `limit` with this p-value.
fn p_above(samples: &[f64], limit: f64) -> f64 {
    if mean_and_error(samples).0 <= limit {
        1.0
    } else {
        p_of_mean(samples, limit, 0.0) / 2.0
    }
}

fn returns_no_more_than_it_may(interface: &Interface, level: f64, by: By) -> TestCaseResult {
    let case = &interface.case;
    let prepared = case.prepared();
    let excess = interface.limits(&prepared).and_then(|limits| {
        let all = made(by, case, &prepared, SPP)?;
        excess(&limits, &all, &case.settings, level)
    });
    prop_assert_eq!(excess, None);
    Ok(())
}

/// The level of the test of each renderer's channels, three of both, at which correct renderers fail one in a thousand runs
/// with that many cases (Šidák).
fn level(cases: u32) -> f64 {
    sidak(1e-3, cases as usize * 3 * 3)
}

#[test]
fn no_interface_returns_more_than_it_may_by_the_references() {
    let cases = 300;
    let level = level(cases);
    check_property(FILE, cases, 10, interface(), |i| {
        returns_no_more_than_it_may(i, level, By::References)
    });
}

#[test]
fn no_interface_returns_more_than_it_may_by_the_device() {
    let cases = 12;
    let level = level(cases);
    check_property(FILE, cases, 11, interface(), |i| {
        returns_no_more_than_it_may(i, level, COMPOSED)
    });
}

/// So many of each of the long runs' seeds.
fn in_many_scenes(cases: u32, by: By) {
    let seeds = long_seeds();
    let level = level(cases * seeds.clone().count() as u32);
    for seed in seeds {
        check_property(FILE, cases, seed, interface(), |i| {
            returns_no_more_than_it_may(i, level, by)
        });
    }
}

#[test]
#[ignore = "minutes"]
fn no_interface_returns_more_than_it_may_by_the_references_in_many_scenes() {
    in_many_scenes(2000, By::References);
}

#[test]
#[ignore = "minutes"]
fn no_interface_returns_more_than_it_may_by_the_device_in_many_scenes() {
    in_many_scenes(100, COMPOSED);
}
