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

/// The notes of standard errors, after lines that say what the values are and with how many degrees of freedom.
pub fn stderr_notes(freedom: f64, job: &Job, device: &str) -> Vec<(&'static str, String)> {
    let from = match job.settings.sampler == Sampler::Random.name() {
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
    ];
    all.extend(notes(job, device));
    all
}

const FREEDOM: &str = "degrees of freedom";

/// The degrees of freedom that standard errors with these notes have, as a file has them; `None` where they do not say.
pub fn noted_freedom(notes: &str) -> Option<f64> {
    let mut lines = notes.lines().filter_map(|l| l.split_once(": "));
    let (_, value) = lines.find(|(name, _)| *name == FREEDOM)?;
    value.parse().ok().filter(|&freedom: &f64| freedom > 0.0)
}
