//! The notes in a picture's header: everything that the picture depends on, and nothing else.

use std::collections::{BTreeMap, BTreeSet};

use super::difference::Difference;
use super::digest::digest;
use super::names::Named;
use super::{Denoised, Job, SOFTWARE};
use crate::film::{Aov, Film};

/// Names and values, in a fixed order. Two runs that make the same picture have the same notes.
pub fn notes(job: &Job, device: &str) -> Vec<(&'static str, String)> {
    let [width, height] = job.size;
    let mut notes = vec![
        ("scene", job.scene.clone()),
        ("size", format!("{width}x{height}")),
    ];
    if let Some([x0, y0, x1, y1]) = job.crop {
        notes.push(("crop", format!("{x0},{y0},{x1},{y1}")));
    }
    if let Some([begin, end]) = job.range {
        notes.push(("samples", format!("{begin}..{end}")));
    }
    notes.extend([
        ("settings", job.settings.to_string()),
        ("spp", job.spp.to_string()),
        ("seed", job.seed.to_string()),
        ("device", device.to_owned()),
        ("version", SOFTWARE.to_owned()),
    ]);
    notes
}

/// The note of a picture with layers: they are means over its first `samples`.
pub fn layer_note(samples: u32) -> (&'static str, String) {
    ("layers", format!("means over the first {samples} samples"))
}

/// The note of a picture whose light is split by classes of paths.
pub fn light_note(job: &Job) -> (&'static str, String) {
    let what = format!("of classes of paths, means over all {} samples", job.spp);
    ("light", what)
}

/// The notes of a denoised picture, after a line that says that it is denoised.
pub fn denoised_notes(denoised: &Denoised, job: &Job, device: &str) -> Vec<(&'static str, String)> {
    let mut all = vec![("denoised", format!("by {}", denoised.by))];
    all.extend(notes(job, device));
    all
}

/// The notes of standard errors, after lines with the meaning of the values, their degrees of freedom, and the digest of
/// the picture: after a change of the scene, another picture may have the same name, settings and seed.
pub fn stderr_notes(
    freedom: f64,
    picture: &Film,
    job: &Job,
    device: &str,
) -> Vec<(&'static str, String)> {
    // Two groups leave one degree of freedom; so do two samples, which are groups of one.
    let from = match freedom > 1.0 {
        true => "the spread of independent samples",
        false => "the difference of two independent groups of samples",
    };
    let name = Aov::Stderr.name();
    let mut all = vec![
        (
            "aov",
            format!("{name}: standard error of the mean, per pixel and channel, from {from}"),
        ),
        (FREEDOM, freedom.to_string()),
        (PICTURE, digest(picture)),
    ];
    all.extend(notes(job, device));
    all
}

const FREEDOM: &str = "degrees of freedom";
const PICTURE: &str = "digest of the picture";

/// The [`digest`] of the picture to which standard errors with these notes belong.
pub fn noted_digest(notes: &str) -> Option<&str> {
    noted(notes, PICTURE)
}

/// The degrees of freedom of standard errors with these notes; `None` if not noted.
pub fn noted_freedom(notes: &str) -> Option<f64> {
    let freedom = noted(notes, FREEDOM)?.parse().ok();
    freedom.filter(|&freedom: &f64| freedom > 0.0)
}

/// The names of [`notes`].
const NAMES: [&str; 8] = [
    "scene", "size", "crop", SETTINGS, "spp", "seed", "device", "version",
];

const SETTINGS: &str = "settings";

/// Whether a file notes how it was made.
pub fn is_noted(notes: &str) -> bool {
    NAMES.iter().any(|name| noted(notes, name).is_some())
}

/// Differences in how two files were made; `None` if one of them has no notes.
pub fn differences(a: &str, b: &str) -> Option<Vec<Difference>> {
    if !is_noted(a) || !is_noted(b) {
        return None;
    }
    let of = |name: &&str| {
        let pair = [a, b].map(|notes| noted(notes, name));
        match *name {
            SETTINGS => of_settings(pair.map(Option::unwrap_or_default)),
            _ => {
                let values = pair.map(|value| value.unwrap_or("none").to_owned());
                Difference::new(name, values).into_iter().collect()
            }
        }
    };
    Some(NAMES.iter().flat_map(of).collect())
}

/// The settings that differ in two texts such as `max-depth=8 roulette=off`. One that a text lacks has its default there.
fn of_settings(texts: [&str; 2]) -> Vec<Difference> {
    let both = texts.map(|text| {
        let words = text.split(' ').filter_map(|word| word.split_once('='));
        words.collect::<BTreeMap<_, _>>()
    });
    let names: BTreeSet<&str> = both.iter().flat_map(BTreeMap::keys).copied().collect();
    let of = |name: &&str| {
        let value = |words: &BTreeMap<&str, &str>| words.get(name).copied().map(str::to_owned);
        let values = both.each_ref().map(value);
        Difference::new(name, values.map(|v| v.unwrap_or("the default".to_owned())))
    };
    names.iter().filter_map(of).collect()
}

fn noted<'a>(notes: &'a str, name: &str) -> Option<&'a str> {
    let mut lines = notes.lines().filter_map(|l| l.split_once(": "));
    lines
        .find(|(found, _)| *found == name)
        .map(|(_, value)| value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_note_that_differs_is_named() {
        let notes = "aov: a\nscene: a.txt\nsize: 4x3\nsettings: lobe=norms max-depth=none\nspp: 16\nseed: 0\n\
            device: cpu-f32\nversion: vkpt 1\n";
        let of = |other: &str| {
            let all = differences(notes, other)?;
            Some(all.iter().map(|each| each.between(["a", "b"])).collect())
        };
        assert_eq!(of(notes), Some(Vec::new()));
        assert_eq!(of(&notes.replace("aov: a", "aov: b")), Some(Vec::new()));
        for (from, to, message) in [
            ("scene: a", "scene: b", "scene is a.txt in a and b.txt in b"),
            ("4x3", "5x3", "size is 4x3 in a and 5x3 in b"),
            (
                "\nseed",
                "\ncrop: 0,0,1,1\nseed",
                "crop is none in a and 0,0,1,1 in b",
            ),
            ("none", "3", "max-depth is none in a and 3 in b"),
            (
                " max",
                " sampler=a max",
                "sampler is the default in a and a in b",
            ),
            ("16", "64", "spp is 16 in a and 64 in b"),
            ("seed: 0", "seed: 1", "seed is 0 in a and 1 in b"),
            ("f32", "f64", "device is cpu-f32 in a and cpu-f64 in b"),
            ("vkpt 1", "vkpt 2", "version is vkpt 1 in a and vkpt 2 in b"),
        ] {
            let changed = notes.replace(from, to);
            assert_eq!(of(&changed), Some(vec![message.to_owned()]));
        }
        let two = notes.replace("16", "64").replace("seed: 0", "seed: 1");
        assert_eq!(of(&two).map(|all| all.len()), Some(2));
        for silent in ["", "Rendered by another program", "exposure: 1"] {
            assert_eq!((of(silent), differences(silent, notes)), (None, None));
        }
    }
}
