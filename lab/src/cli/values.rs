//! The values that flags take.

use clap::builder::{OsStringValueParser, PossibleValuesParser, TypedValueParser};

use super::destination::Destination;
use vkpt::gpu::Selector;
use vkpt::image::Format;
use vkpt::render::Target;
use vkpt::report::names::Named;
use vkpt::settings::{DistributionRule, Integrator};

/// A named set of settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    Handout,
}

impl Named for Preset {
    const ALL: &'static [(Self, &'static str)] = &[(Self::Handout, "handout")];
}

/// One of few, by name.
pub fn choice<T: Named>() -> impl TypedValueParser<Value = T> {
    named(T::ALL.to_vec())
}

/// `auto`, or the name of a distribution.
pub fn distribution() -> impl TypedValueParser<Value = DistributionRule> {
    auto_or(DistributionRule::Auto, DistributionRule::Always)
}

/// The integrator: the same for every scene, or the one that suits it.
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

/// A file whose ending is .png, or stdout under any name, a device or a pipe.
pub fn png() -> impl TypedValueParser<Value = Destination> {
    OsStringValueParser::new().try_map(|word| {
        let to = Destination::from(word);
        match to.neighbour().map(Format::of) {
            None | Some(Some(Format::Png)) => Ok(to),
            _ => Err("the ending must be .png"),
        }
    })
}

/// A device.
pub fn device(text: &str) -> Result<Target, std::convert::Infallible> {
    let is = |name: &str| text.eq_ignore_ascii_case(name);
    Ok(match () {
        () if is("cpu-f32") => Target::CpuF32,
        () if is("cpu-f64") => Target::CpuF64,
        () => Target::Vulkan(text.into()),
    })
}

/// The devices that render one picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Devices {
    One(Target),
    /// Each renders a part of the samples.
    Several(Vec<Target>),
}

/// A device; or several, by their indices, and `cpu-f32`, with commas between: names may have commas.
pub fn devices(text: &str) -> Result<Devices, String> {
    let words: Vec<Target> = text
        .split(',')
        .filter_map(|word| device(word).ok())
        .collect();
    let numbered = |t: &Target| !matches!(t, Target::Vulkan(Selector::Name(_) | Selector::Best));
    if words.len() < 2 || !words.iter().all(numbered) {
        return device(text)
            .map(Devices::One)
            .map_err(|never| match never {});
    }
    match words.contains(&Target::CpuF64) {
        true => Err(
            "cpu-f64 rounds differently from all others and cannot share samples: name it alone"
                .to_owned(),
        ),
        false => Ok(Devices::Several(words)),
    }
}

/// A Vulkan device.
pub fn vulkan_device(text: &str) -> Result<Selector, String> {
    match device(text) {
        Ok(Target::Vulkan(selector)) => Ok(selector),
        _ => Err("must be a Vulkan device, not a reference renderer".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_by_index_and_by_name() {
        let vulkan = |selector| Ok(Target::Vulkan(selector));
        assert_eq!(device("1"), vulkan(Selector::Index(1)));
        assert_eq!(
            device("llvmpipe"),
            vulkan(Selector::Name("llvmpipe".to_owned()))
        );
        assert_eq!(device("cpu-f32"), Ok(Target::CpuF32));
        assert_eq!(device("CPU-F64"), Ok(Target::CpuF64));
        let index = |i| Target::Vulkan(Selector::Index(i));
        let several = |all: &[Target]| Ok(Devices::Several(all.to_vec()));
        assert_eq!(devices("0,1"), several(&[index(0), index(1)]));
        assert_eq!(devices("0,cpu-f32"), several(&[index(0), Target::CpuF32]));
        assert_eq!(devices("1"), Ok(Devices::One(index(1))));
        let long = "llvmpipe (LLVM 15.0.6, 256 bits)";
        assert_eq!(devices(long), Ok(Devices::One(Target::Vulkan(long.into()))));
        assert!(devices("0,cpu-f64").is_err());
    }

    #[test]
    fn pngs() {
        let png = |word: &str| {
            let command = clap::Command::new("test").arg(clap::Arg::new("to").value_parser(png()));
            let mut matches = command.try_get_matches_from(["test", word]).ok()?;
            matches.remove_one::<Destination>("to")
        };
        assert_eq!(png("-"), Some(Destination::Stdout));
        assert_eq!(png("a/b.PNG"), Some(Destination::File("a/b.PNG".into())));
        assert!(["a.exr", "png", "a"].iter().all(|name| png(name).is_none()));
    }
}
