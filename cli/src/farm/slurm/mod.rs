//! A farm as scripts for Slurm, which a person can read, edit and keep.

use super::Farm;
use vkpt::shell::{self, quoted};

/// A file of a farm's folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Script {
    pub name: &'static str,
    pub text: String,
}

/// The texts, in which `@NAME@` is replaced by a value.
const SCRIPTS: [(&str, &str); 4] = [
    ("farm.sh", include_str!("scripts/farm.sh")),
    ("part.sbatch", include_str!("scripts/part.sbatch")),
    ("merge.sbatch", include_str!("scripts/merge.sbatch")),
    ("submit.sh", include_str!("scripts/submit.sh")),
];
const ROUNDS: &str = include_str!("scripts/rounds.sh");
const ERROR: &str = include_str!("scripts/error.sh");
const TIME: &str = include_str!("scripts/time.sh");

/// Records when the first part started, for [`TIME`].
const STARTED: &str = "[ -e started ] || date +%s >started\n";

/// The files of a farm's folder.
pub fn slurm(farm: &Farm) -> Vec<Script> {
    let texts = SCRIPTS.map(|(name, text)| (name, fill(text, &values(farm))));
    let tables = [
        ("parts.txt", parts(farm)),
        // The current round.
        ("round", "1\n".to_owned()),
    ];
    let all = texts.into_iter().chain(tables);
    all.map(|(name, text)| Script { name, text }).collect()
}

/// A line for each part: its round, its first sample and its end.
fn parts(farm: &Farm) -> String {
    let rounds = (1..).zip(&farm.rounds);
    let parts = rounds.flat_map(|(round, shares)| shares.iter().map(move |s| (round, s)));
    parts
        .map(|(round, share)| format!("{round} {} {}\n", share.start, share.end))
        .collect()
}

fn values(farm: &Farm) -> Vec<(&'static str, String)> {
    let pictures = farm.pictures.iter().flat_map(|file| ["-o", file]);
    let partition = farm.partition.as_ref();
    let partition = partition.map(|name| format!("#SBATCH --partition={}\n", option(name)));
    let started = farm.seconds.map(|_| STARTED.to_owned());
    vec![
        ("vkpt", quoted(&farm.vkpt)),
        ("rendering", shell::line(&farm.rendering)),
        ("pictures", shell::line(pictures)),
        ("folder", quoted(&farm.folder)),
        ("name", option(&farm.name)),
        ("chdir", option(&farm.folder)),
        ("partition", partition.unwrap_or_default()),
        ("started", started.unwrap_or_default()),
        ("rounds", next_round(farm)),
    ]
}

/// The commands of a merge if more samples may be needed.
fn next_round(farm: &Farm) -> String {
    let by = |text, name, value: Option<f64>| {
        value.map_or_else(String::new, |value| {
            fill(text, &[(name, value.to_string())])
        })
    };
    let error = by(ERROR, "target", farm.target_error);
    let time = by(TIME, "seconds", farm.seconds);
    match error.is_empty() && time.is_empty() {
        true => String::new(),
        false => fill(ROUNDS, &[("error", error), ("time", time)]),
    }
}

/// A value of an option as sbatch reads it in a script: in double quotes, with a backslash before quotes and backslashes.
fn option(value: &str) -> String {
    format!("\"{}\"", value.replace('\\', r"\\").replace('"', r#"\""#))
}

/// The text with every `@NAME@` filled in, in one pass: a value may itself contain `@NAME@`.
fn fill(text: &str, values: &[(&str, String)]) -> String {
    let mut words = text.split('@');
    let mut filled = words.next().unwrap_or_default().to_owned();
    while let Some(name) = words.next() {
        match values.iter().find(|(known, _)| *known == name) {
            Some((_, value)) => {
                filled += value;
                filled += words.next().unwrap_or_default();
            }
            // As in `USR1@60`.
            None => filled = filled + "@" + name,
        }
    }
    filled
}
