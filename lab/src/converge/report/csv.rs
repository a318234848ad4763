//! A line for each variant and step (RFC 4180).

use super::{Convergence, ErrorRecord, StepRecord, VariantRecord};
use vkpt::metrics::convergence::{Interval, Metric};

/// The whole experiment; unknown values are empty.
pub fn csv(experiment: &Convergence) -> String {
    let mut text = head();
    for variant in &experiment.variants {
        for step in &variant.steps {
            text += &line(variant, step);
        }
    }
    text
}

fn head() -> String {
    let mut names: Vec<String> = ["variant", "spp", "wall_s", "wall_with_set_up_s", "gpu_s"]
        .map(str::to_owned)
        .into();
    for (_, metric) in Metric::ALL {
        for of in [
            "",
            "_low",
            "_high",
            "_trimmed",
            "_median",
            "_below_reference",
        ] {
            names.push(format!("{metric}{of}"));
        }
    }
    for of in ["slope", "efficiency"] {
        names.extend(["", "_low", "_high"].map(|end| format!("{of}{end}")));
    }
    names.join(",") + "\n"
}

fn line(variant: &VariantRecord, step: &StepRecord) -> String {
    let mut cells = vec![
        quoted(&variant.name),
        step.spp.to_string(),
        step.wall_s.value.to_string(),
        step.wall_with_set_up_s.to_string(),
        step.gpu_s.map_or(String::new(), |s| s.value.to_string()),
    ];
    for (metric, _) in Metric::ALL {
        cells.extend(error(step.errors.of(metric)));
    }
    cells.extend(interval(step.slope));
    cells.extend(interval(step.efficiency));
    cells.join(",") + "\n"
}

fn error(error: &ErrorRecord) -> impl Iterator<Item = String> {
    let summary = &error.summary;
    let rest = [summary.trimmed, summary.median_of_means].map(|x| x.to_string());
    interval(Some(summary.mean))
        .into_iter()
        .chain(rest)
        .chain([error.below_reference.to_string()])
}

fn interval(interval: Option<Interval>) -> [String; 3] {
    interval.map_or_else(Default::default, |i| {
        [i.value, i.low, i.high].map(|x| x.to_string())
    })
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
