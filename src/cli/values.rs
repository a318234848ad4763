//! The values that flags take.

use std::ffi::OsString;

use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::destination::Destination;
use crate::gpu::Selector;
use crate::image::Format;
use crate::render::{KernelChoice, Target};
use crate::report::names::Named;
use crate::scene::LARGEST_SIDE;
use crate::settings::{DistributionRule, Integrator, Roulette};

/// A named set of settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    Handout,
}

/// Another renderer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Peer {
    Mitsuba,
}

/// One sample of one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SamplePath {
    /// Column and row, from the top left.
    pub pixel: [u32; 2],
    pub index: u32,
}

impl Named for Preset {
    const ALL: &'static [(Self, &'static str)] = &[(Self::Handout, "handout")];
}

impl Named for Peer {
    const ALL: &'static [(Self, &'static str)] = &[(Self::Mitsuba, "mitsuba")];
}

impl Named for KernelChoice<'static> {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Composed, "composed"), (Self::Full, "full")];
}

impl Named for Format {
    const ALL: &'static [(Self, &'static str)] =
        &[(Self::Png, "png"), (Self::Hdr, "hdr"), (Self::Exr, "exr")];
}

/// One of few, by name.
pub fn choice<T: Named>() -> impl TypedValueParser<Value = T> {
    named(T::ALL.to_vec())
}

/// `auto`, or the name of a distribution.
pub fn distribution() -> impl TypedValueParser<Value = DistributionRule> {
    auto_or(DistributionRule::Auto, DistributionRule::Always)
}

/// Which integrator: the same for every scene, or the one that suits it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IntegratorRule {
    Auto,
    Always(Integrator),
}

/// `auto`, or the name of an integrator.
pub fn integrator() -> impl TypedValueParser<Value = IntegratorRule> {
    auto_or(IntegratorRule::Auto, IntegratorRule::Always)
}

/// `auto`, or the name of one of few.
fn auto_or<T: Named, R: Copy + Send + Sync + 'static>(
    auto: R,
    always: fn(T) -> R,
) -> impl TypedValueParser<Value = R> {
    let one = T::ALL.iter().map(|&(which, name)| (always(which), name));
    named([(auto, "auto")].into_iter().chain(one).collect())
}

/// `on` or `off`.
pub fn switch() -> impl TypedValueParser<Value = bool> {
    named(vec![(true, "on"), (false, "off")])
}

fn named<T: Copy + Send + Sync + 'static>(
    all: Vec<(T, &'static str)>,
) -> impl TypedValueParser<Value = T> {
    let names = PossibleValuesParser::new(all.iter().map(|&(_, name)| name));
    names.try_map(move |given| {
        let found = all.iter().find(|(_, name)| *name == given);
        found.map(|&(value, _)| value).ok_or("no such value")
    })
}

/// A file whose ending is .png, or stdout.
pub fn png(text: &str) -> Result<Destination, String> {
    let to = Destination::from(OsString::from(text));
    match to.path().map(Format::of) {
        None | Some(Some(Format::Png)) => Ok(to),
        _ => Err("the ending must be .png".to_owned()),
    }
}

/// The most that an error may be.
pub fn bound(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(bound) if bound >= 0.0 && bound.is_finite() => Ok(bound),
        _ => Err("must be a finite number from 0 up, such as 1e-3".to_owned()),
    }
}

/// A time to render for.
pub fn seconds(text: &str) -> Result<f64, String> {
    positive(text).ok_or("must be a finite number of seconds above 0, such as 60".to_owned())
}

/// The relMSE to be reached.
pub fn target_error(text: &str) -> Result<f64, String> {
    positive(text).ok_or("must be a finite number above 0, such as 1e-3".to_owned())
}

fn positive(text: &str) -> Option<f64> {
    let number: f64 = text.parse().ok()?;
    (number > 0.0 && number.is_finite()).then_some(number)
}

/// `WxH`, both from 1 to [`LARGEST_SIDE`].
pub fn size(text: &str) -> Result<[u32; 2], String> {
    match numbers(text, 'x') {
        Some(size) if size.iter().all(|side| (1..=LARGEST_SIDE).contains(side)) => Ok(size),
        Some(_) => Err(format!("each side must be from 1 to {LARGEST_SIDE} pixels")),
        None => Err("must be two whole numbers, such as 400x300".to_owned()),
    }
}

/// `X0,Y0,X1,Y1`, not empty.
pub fn crop(text: &str) -> Result<[u32; 4], String> {
    match numbers(text, ',') {
        Some([x0, y0, x1, y1]) if x0 < x1 && y0 < y1 => Ok([x0, y0, x1, y1]),
        Some(_) => Err("no pixels: X0 must be below X1 and Y0 below Y1".to_owned()),
        None => Err("must be four whole numbers, such as 0,0,64,64".to_owned()),
    }
}

/// `X,Y,I`.
pub fn sample_path(text: &str) -> Result<SamplePath, String> {
    let [x, y, index] = numbers(text, ',').ok_or("must be three whole numbers, such as 10,20,0")?;
    if index == u32::MAX {
        return Err(format!("the last sample has the index {}", u32::MAX - 1));
    }
    Ok(SamplePath {
        pixel: [x, y],
        index,
    })
}

/// A device.
pub fn device(text: &str) -> Result<Target, std::convert::Infallible> {
    Ok(match text {
        "cpu-f32" => Target::CpuF32,
        "cpu-f64" => Target::CpuF64,
        _ => Target::Vulkan(text.into()),
    })
}

/// A Vulkan device.
pub fn vulkan_device(text: &str) -> Result<Selector, String> {
    match device(text) {
        Ok(Target::Vulkan(selector)) => Ok(selector),
        _ => Err("must be a Vulkan device: the reference renderers are there anyway".to_owned()),
    }
}

/// `throughput`, `off`, or a probability above 0 and up to 1.
pub fn roulette(text: &str) -> Result<Roulette, String> {
    match text {
        "throughput" => Ok(Roulette::Throughput),
        "off" => Ok(Roulette::Off),
        _ => match text.parse() {
            Ok(p) if p > 0.0 && p <= 1.0 => Ok(Roulette::Constant(p)),
            Ok(_) => Err("a probability of survival must be above 0 and at most 1".to_owned()),
            Err(_) => Err("must be throughput, off, or a probability such as 0.8".to_owned()),
        },
    }
}

/// A number of stops.
pub fn exposure(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(stops) if stops.is_finite() => Ok(stops),
        _ => Err("must be a finite number of stops, such as -1.5".to_owned()),
    }
}

/// Exactly N whole numbers with `separator` between them.
fn numbers<const N: usize>(text: &str, separator: char) -> Option<[u32; N]> {
    let all: Result<Vec<u32>, _> = text.split(separator).map(str::parse).collect();
    all.ok()?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_crops() {
        assert_eq!(size("400x300"), Ok([400, 300]));
        assert_eq!(size("1x16384"), Ok([1, 16384]));
        for wrong in [
            "",
            "400",
            "400x",
            "400x300x2",
            "4.5x3",
            "-1x2",
            "0x300",
            "400x0",
            "1x16385",
            "4e2x300",
        ] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
        assert_eq!(crop("0,1,2,3"), Ok([0, 1, 2, 3]));
        for wrong in [
            "",
            "0,0,1",
            "0,0,1,1,1",
            "1,0,1,1",
            "0,1,1,1",
            "2,0,1,1",
            "0,0,1,-1",
            "0 ,0,1,1",
        ] {
            assert!(crop(wrong).is_err(), "{wrong}");
        }
        assert_eq!(
            sample_path("3,4,5"),
            Ok(SamplePath {
                pixel: [3, 4],
                index: 5
            })
        );
        assert!(sample_path("3,4").is_err());
        assert!(sample_path("3,4,4294967294").is_ok() && sample_path("3,4,4294967295").is_err());
    }

    #[test]
    fn roulettes() {
        assert_eq!(roulette("throughput"), Ok(Roulette::Throughput));
        assert_eq!(roulette("off"), Ok(Roulette::Off));
        assert_eq!(roulette("0.8"), Ok(Roulette::Constant(0.8)));
        assert_eq!(roulette("1"), Ok(Roulette::Constant(1.0)));
        for wrong in ["0", "-0.5", "1.01", "NaN", "inf", "on", ""] {
            assert!(roulette(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn devices() {
        let vulkan = |selector| Ok(Target::Vulkan(selector));
        assert_eq!(device("1"), vulkan(Selector::Index(1)));
        assert_eq!(
            device("llvmpipe"),
            vulkan(Selector::Name("llvmpipe".to_owned()))
        );
        assert_eq!(device("cpu-f32"), Ok(Target::CpuF32));
        assert_eq!(device("cpu-f64"), Ok(Target::CpuF64));
    }

    #[test]
    fn pngs_and_exposures() {
        assert_eq!(png("-"), Ok(Destination::Stdout));
        assert_eq!(png("a/b.PNG"), Ok(Destination::File("a/b.PNG".into())));
        assert!(["a.exr", "png", "a"].iter().all(|name| png(name).is_err()));
        assert_eq!(exposure("-1.5"), Ok(-1.5));
        assert!(
            ["NaN", "inf", "x", ""]
                .iter()
                .all(|text| exposure(text).is_err())
        );
    }
}
