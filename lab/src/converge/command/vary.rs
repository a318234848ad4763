//! Settings that vary: any that has a flag, with the flag's name and values.

use clap::error::ErrorKind;
use clap::{Args, Command, FromArgMatches};

use crate::cli::denoise::By;
use crate::cli::exit::Failure;
use crate::cli::integrator;
use crate::cli::settings::SettingArguments;
use vkpt::report::names::Named;
use vkpt::settings::Settings;

/// A setting and its values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vary {
    name: String,
    values: Vec<String>,
}

/// A combination of values.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// `connect=light normals=visible`; empty where nothing varies.
    pub name: String,
    pub settings: Settings,
    /// Whether the scene chooses its integrator.
    pub auto: bool,
    /// The denoiser of the pictures before they are judged.
    pub denoise: Option<By>,
}

/// The denoiser: not a setting of the rendering.
const DENOISE: &str = "denoise";
const NO_DENOISER: &str = "off";

/// The most variants, each of which gets a table.
const MOST: usize = 64;

/// `NAME=VALUE,VALUE…`, each a value that `--NAME` takes.
pub fn vary(text: &str) -> Result<Vary, String> {
    let (name, values) = text
        .split_once('=')
        .ok_or("must be a setting and its values, such as connect=mis,light")?;
    let values: Vec<String> = values.split(',').map(str::to_owned).collect();
    for (i, value) in values.iter().enumerate() {
        match name {
            DENOISE => denoiser(value).map(|_| ()),
            _ => flags(&[(name, value)]).map(|_| ()),
        }?;
        if values[..i].contains(value) {
            return Err(format!("{value} is given twice"));
        }
    }
    Ok(Vary {
        name: name.to_owned(),
        values,
    })
}

/// All combinations, the last setting varying fastest, applied over the other flags.
pub fn combinations(
    settings: &SettingArguments,
    vary: &[Vary],
) -> Result<Vec<Combination>, Failure> {
    for (i, v) in vary.iter().enumerate() {
        if vary[..i].iter().any(|other| other.name == v.name) {
            return Err(Failure::Usage(format!(
                "--vary {} is given twice: give all of its values at once",
                v.name
            )));
        }
    }
    let count = vary
        .iter()
        .try_fold(1usize, |n, v| n.checked_mul(v.values.len()));
    if count.is_none_or(|n| n > MOST) {
        return Err(Failure::Usage(format!(
            "--vary: more than {MOST} combinations"
        )));
    }
    let mut all: Vec<Vec<(&str, &str)>> = vec![Vec::new()];
    for v in vary {
        let each = |so_far: Vec<_>| {
            let with = move |value| [&so_far[..], &[(v.name.as_str(), value)]].concat();
            v.values.iter().map(String::as_str).map(with)
        };
        all = all.into_iter().flat_map(each).collect();
    }
    let combination = |pairs: &Vec<(&str, &str)>| {
        let names: Vec<String> = pairs.iter().map(|(n, v)| format!("{n}={v}")).collect();
        let (denoise, others): (Vec<_>, Vec<_>) = pairs.iter().partition(|(n, _)| *n == DENOISE);
        let denoise = denoise.first().map(|(_, value)| denoiser(value));
        let denoise = denoise.transpose().map_err(Failure::Usage)?.flatten();
        let flags = flags(&others).map_err(Failure::Usage)?;
        let auto = flags.integrator.map_or(settings.auto(), |_| flags.auto());
        let settings = settings.with(&flags);
        integrator::check(&settings)?;
        Ok(Combination {
            name: names.join(" "),
            settings,
            auto,
            denoise,
        })
    };
    all.iter().map(combination).collect()
}

/// `off`, or a value of `--denoise`.
fn denoiser(value: &str) -> Result<Option<By>, String> {
    let by = By::ALL.iter().find(|(_, name)| *name == value);
    match by {
        Some((by, _)) => Ok(Some(*by)),
        None if value == NO_DENOISER => Ok(None),
        None => {
            let names: Vec<&str> = By::ALL.iter().map(|(_, name)| *name).collect();
            let names = names.join(", ");
            Err(format!("denoise={value}: must be {NO_DENOISER}, {names}"))
        }
    }
}

/// The flags that a command line would have: `--NAME=VALUE` for each pair.
fn flags(pairs: &[(&str, &str)]) -> Result<SettingArguments, String> {
    let command = Command::new("vary")
        .no_binary_name(true)
        .disable_help_flag(true);
    let command = SettingArguments::augment_args(command);
    let known: Vec<String> = command
        .get_arguments()
        .filter_map(|a| a.get_long().map(str::to_owned))
        .collect();
    let words = pairs
        .iter()
        .map(|(name, value)| format!("--{name}={value}"));
    let explained = |error: clap::Error| match error.kind() {
        ErrorKind::UnknownArgument => {
            format!(
                "no such setting; the settings are {}, {DENOISE}",
                known.join(", ")
            )
        }
        _ => first_paragraph(&error.to_string()),
    };
    command
        .try_get_matches_from(words)
        .and_then(|matches| SettingArguments::from_arg_matches(&matches))
        .map_err(explained)
}

/// The first paragraph of clap's message, before its pointer to the help.
fn first_paragraph(text: &str) -> String {
    let lines = text.lines().take_while(|line| !line.is_empty());
    let lines: Vec<&str> = lines.map(str::trim).collect();
    let all = lines.join(" ");
    all.strip_prefix("error: ").unwrap_or(&all).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use vkpt::settings::{Connect, LobeChoice, Normals};

    fn given(words: &[&str]) -> SettingArguments {
        let pairs: Vec<_> = words.iter().filter_map(|w| w.split_once('=')).collect();
        flags(&pairs).expect("flags")
    }

    #[test]
    fn every_combination_is_made_over_the_other_flags() {
        let varied = ["connect=mis,light,bsdf", "normals=distribution,visible"]
            .map(|text| vary(text).expect("a setting"));
        let all = combinations(&given(&["lobe=norms", "connect=bsdf"]), &varied).expect("all");
        let names: Vec<_> = all.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names.len(), 6);
        assert_eq!(names[0], "connect=mis normals=distribution");
        assert_eq!(names[3], "connect=light normals=visible");
        let estimator = all[3].settings.estimator;
        assert_eq!(
            (estimator.connect, estimator.normals, estimator.lobe),
            (Connect::Light, Normals::Visible, LobeChoice::Norms)
        );
        assert!(
            all.iter()
                .all(|c| c.settings.model == Settings::default().model)
        );
        let denoised = [vary("denoise=off,nlm").expect("denoisers")];
        let both = combinations(&given(&[]), &denoised).expect("two");
        assert_eq!([both[0].denoise, both[1].denoise], [None, Some(By::Nlm)]);
        assert_eq!(both[0].settings, both[1].settings);
        let alone = combinations(&given(&["connect=bsdf"]), &[]).expect("one");
        assert_eq!(alone.len(), 1);
        assert_eq!(alone[0].name, "");
        assert_eq!(alone[0].settings.estimator.connect, Connect::Bsdf);
    }

    #[test]
    fn a_varied_preset_is_under_the_flags() {
        let varied = [vary("model=handout").expect("a preset")];
        let all = combinations(&given(&["lobe=fresnel"]), &varied).expect("one");
        let mut expected = Settings::handout();
        expected.estimator.lobe = LobeChoice::Fresnel;
        assert_eq!(all[0].settings, expected);
    }

    #[test]
    fn unknown_settings_and_values_are_named() {
        for (text, expected) in [
            ("connect", "connect=mis,light"),
            (
                "colour=red",
                "no such setting; the settings are model, fresnel",
            ),
            ("help=1", "no such setting"),
            ("connect=mis,all", "invalid value 'all'"),
            ("connect=mis,all", "mis, light, bsdf"),
            ("connect=mis,mis", "mis is given twice"),
            ("connect=", "value"),
            ("denoise=blur", "must be off, auto, oidn, nlm"),
            ("max-depth=-1", "-1"),
        ] {
            let error = vary(text).expect_err("refused");
            assert!(error.contains(expected), "{text}: {error}");
        }
        let twice = ["connect=mis", "connect=light"].map(|text| vary(text).expect("a setting"));
        assert!(combinations(&given(&[]), &twice).is_err());
    }
}
