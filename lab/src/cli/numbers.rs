//! The numbers that flags take, and lists of them.

use std::any::TypeId;
use std::ops::Range;
use std::time::Duration;

use clap::Arg;

use vkpt::scene::LARGEST_SIDE;
use vkpt::settings::Roulette;

/// One sample of one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SamplePath {
    /// Column and row, from the top left.
    pub pixel: [u32; 2],
    pub index: u32,
}

/// Time between two checkpoints; `None` disables them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pause(pub Option<Duration>);

/// Lets a flag that takes numbers accept a leading minus, so that its own parser reports the error. clap would take the
/// value for another flag.
pub fn negative(flag: Arg) -> Arg {
    let taken = flag.get_value_parser().type_id();
    let numbers = [
        TypeId::of::<u32>(),
        TypeId::of::<f64>(),
        TypeId::of::<[u32; 2]>(),
        TypeId::of::<[u32; 4]>(),
        TypeId::of::<SamplePath>(),
        TypeId::of::<Range<u32>>(),
        TypeId::of::<Pause>(),
        TypeId::of::<Roulette>(),
    ];
    match numbers.iter().any(|number| taken == *number) {
        true => flag.allow_hyphen_values(true),
        false => flag,
    }
}

/// A whole number from `least` up.
pub fn whole(least: u32) -> impl Fn(&str) -> Result<u32, String> + Clone {
    move |text| match text.parse() {
        Ok(number) if number >= least => Ok(number),
        _ => Err(format!(
            "must be a whole number from {least} to {}",
            u32::MAX
        )),
    }
}

/// An upper bound of an error.
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

/// A time between two checkpoints, or `off`.
pub fn pause(text: &str) -> Result<Pause, String> {
    let seconds = |s: f64| Duration::try_from_secs_f64(s).ok().map(Some);
    let pause = match text {
        "off" => Some(None),
        _ => positive(text).and_then(seconds),
    };
    pause
        .map(Pause)
        .ok_or("must be a finite number of seconds above 0, such as 60, or off".to_owned())
}

/// `A..B`, non-empty.
pub fn sample_range(text: &str) -> Result<Range<u32>, String> {
    let ends = text.split_once("..");
    match ends.and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?))) {
        Some((a, b)) if a < b => Ok(a..b),
        Some(_) => Err("no samples: A must be below B".to_owned()),
        None => Err("must be two whole numbers from 0 up, such as 256..512".to_owned()),
    }
}

/// The relMSE to reach.
pub fn target_error(text: &str) -> Result<f64, String> {
    positive(text).ok_or("must be a finite number above 0, such as 1e-3".to_owned())
}

fn positive(text: &str) -> Option<f64> {
    let number: f64 = text.parse().ok()?;
    (number > 0.0 && number.is_finite()).then_some(number)
}

/// A number of stops.
pub fn exposure(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(stops) if stops.is_finite() => Ok(stops),
        _ => Err("must be a finite number of stops, such as -1.5".to_owned()),
    }
}

/// `WxH`, both from 1 to [`LARGEST_SIDE`].
pub fn size(text: &str) -> Result<[u32; 2], String> {
    match numbers(text, 'x') {
        Some(size) if size.iter().all(|side| (1..=LARGEST_SIDE).contains(side)) => Ok(size),
        Some(_) => Err(format!("each side must be from 1 to {LARGEST_SIDE} pixels")),
        None => Err("must be two whole numbers from 1 up, such as 400x300".to_owned()),
    }
}

/// `X0,Y0,X1,Y1`, non-empty.
pub fn crop(text: &str) -> Result<[u32; 4], String> {
    match numbers(text, ',') {
        Some([x0, y0, x1, y1]) if x0 < x1 && y0 < y1 => Ok([x0, y0, x1, y1]),
        Some(_) => Err("no pixels: X0 must be below X1 and Y0 below Y1".to_owned()),
        None => Err("must be four whole numbers from 0 up, such as 0,0,64,64".to_owned()),
    }
}

/// `X,Y,I`.
pub fn sample_path(text: &str) -> Result<SamplePath, String> {
    let [x, y, index] =
        numbers(text, ',').ok_or("must be three whole numbers from 0 up, such as 10,20,0")?;
    if index == u32::MAX {
        return Err(format!("the last sample has the index {}", u32::MAX - 1));
    }
    Ok(SamplePath {
        pixel: [x, y],
        index,
    })
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
    fn one_number() {
        let (samples, seed) = (whole(1), whole(0));
        assert_eq!((samples("1000"), seed("0")), (Ok(1000), Ok(0)));
        assert_eq!(seed("4294967295"), Ok(u32::MAX));
        for wrong in [
            "",
            "0",
            "-1",
            "1e3",
            "1.5",
            "4294967296",
            "inf",
            " 1",
            "1_000",
        ] {
            let message = samples(wrong).expect_err("refused");
            assert!(
                message.contains("from 1 to 4294967295"),
                "{wrong}: {message}"
            );
        }
        assert_eq!(exposure("-1.5"), Ok(-1.5));
        for wrong in ["NaN", "-nan", "inf", "-inf", "x", ""] {
            assert!(exposure(wrong).is_err(), "{wrong}");
        }
    }
}
