//! What a picture's header tells: all that the picture depends on, and nothing else.

use super::names::Named;
use super::{Job, SOFTWARE};
use crate::film::Aov;
use crate::settings::Sampler;

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
    notes.extend([
        ("settings", job.settings.to_string()),
        ("spp", job.spp.to_string()),
        ("seed", job.seed.to_string()),
        ("device", device.to_owned()),
        ("version", SOFTWARE.to_owned()),
    ]);
    notes
}

/// The notes of what is written beside a picture: its own, after a line that says what the values are.
pub fn aov_notes(aov: Aov, job: &Job, device: &str) -> Vec<(&'static str, String)> {
    let values = match (aov, job.settings.sampler == Sampler::Sobol.name()) {
        (Aov::Stderr, false) => {
            "standard error of the mean, per pixel and channel, of independent samples"
        }
        (Aov::Stderr, true) => {
            "standard error of the mean, per pixel and channel, as if samples were independent, which Sobol's are not: \
             more than the error is"
        }
    };
    let mut all = vec![("aov", format!("{}: {values}", aov.name()))];
    all.extend(notes(job, device));
    all
}

/// The sampler of a picture with these notes, as a file has them; `None` where they do not tell.
pub fn noted_sampler(notes: &str) -> Option<Sampler> {
    let settings = notes.lines().find_map(|l| l.strip_prefix("settings: "))?;
    let mut words = settings.split(' ');
    let name = words.find_map(|word| word.strip_prefix("sampler="))?;
    let known = Sampler::ALL.iter().find(|(_, known)| *known == name);
    known.map(|(sampler, _)| *sampler)
}
