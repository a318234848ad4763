//! The experiment for people: a table for each variant, then a comparison of variants.

use super::words::{NONE, between, marked, number, own, reached, with_half_width};
use super::{Convergence, StepRecord, VariantRecord};
use vkpt::metrics::convergence::Metric;
use vkpt::report::human::{duration, plural};

/// The experiment as text.
pub fn table(experiment: &Convergence) -> String {
    let mut text = head(experiment);
    for variant in &experiment.variants {
        text += "\n";
        text += &of_variant(variant);
    }
    if experiment.variants.len() > 1 {
        text += "\n";
        text += &winner(experiment);
    }
    text
}

fn head(e: &Convergence) -> String {
    let [width, height] = e.size;
    let crop = e.crop.map_or(String::new(), |[x0, y0, x1, y1]| {
        format!(", crop {x0},{y0},{x1},{y1}")
    });
    let last = u64::from(e.seed) + e.replicates as u64 - 1;
    format!(
        "{}: {width}×{height}{crop}, {}, seeds {} to {last}, {} of at most {} of sampling used\n\
         on {}, {}\n\
         mean of the replicates (95 % interval, Student's t); trimmed: without the worst 1 % of each one's pixels;\n\
         median: of the replicates; slope: of relMSE over samples, −1 for independent samples\n",
        e.scene,
        plural(e.replicates as u64, "replicate"),
        e.seed,
        duration(e.spent_s),
        duration(e.seconds),
        e.device,
        e.driver,
    )
}

fn of_variant(variant: &VariantRecord) -> String {
    let mut text = String::new();
    if !variant.name.is_empty() {
        text += &format!("{}\n", variant.name);
    }
    text += &lined_up(&rows(variant));
    if variant.steps.iter().any(has_marks) {
        text += "  * not above the reference's own error: inconclusive\n";
    }
    text += &format!(
        "  reference: {}; {}\n  {} of set-up before the first sample, not included above\n",
        variant.reference.name,
        own(&variant.reference.own),
        duration(variant.set_up_s)
    );
    let reach: Vec<String> = variant.reach.iter().map(reached).collect();
    text += &format!("  {}\n", reach.join("; "));
    text + &verdict(variant)
}

const COLUMNS: [&str; 12] = [
    "spp",
    "wall",
    "GPU",
    "relMSE",
    "(95 %)",
    "trimmed",
    "median",
    "slope",
    "RMSE",
    "SMAPE",
    "FLIP",
    "1/(relMSE·s)",
];

type Row = [String; COLUMNS.len()];

fn rows(variant: &VariantRecord) -> Vec<Row> {
    let mut rows = vec![COLUMNS.map(str::to_owned)];
    rows.extend(variant.steps.iter().map(row));
    rows
}

fn row(step: &StepRecord) -> Row {
    let e = &step.errors;
    let rel = &e.rel_mse.summary;
    [
        step.spp.to_string(),
        duration(step.wall_s.value),
        step.gpu_s.map_or(NONE.to_owned(), |s| duration(s.value)),
        marked(&e.rel_mse),
        between(&rel.mean),
        number(rel.trimmed),
        number(rel.median_of_means),
        step.slope.map_or(NONE.to_owned(), |s| with_half_width(&s)),
        marked(&e.rmse),
        marked(&e.smape),
        marked(&e.flip),
        step.efficiency.map_or(NONE.to_owned(), |i| number(i.value)),
    ]
}

/// Right-aligned columns, as wide as their widest cell, two blanks before each.
fn lined_up(rows: &[Row]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max();
    let widths: [usize; COLUMNS.len()] = std::array::from_fn(|c| width(c).unwrap_or(0));
    let line = |row: &Row| {
        let cells = row.iter().zip(widths);
        cells
            .map(|(cell, w)| format!("  {cell:>w$}"))
            .collect::<String>()
            + "\n"
    };
    rows.iter().map(line).collect()
}

fn has_marks(step: &StepRecord) -> bool {
    Metric::ALL
        .iter()
        .any(|&(metric, _)| step.errors.of(metric).below_reference)
}

/// Whether the pictures converge to the reference.
fn verdict(variant: &VariantRecord) -> String {
    let Some(floor) = variant.floor else {
        return String::new();
    };
    let (rel_mse, error) = (number(floor.rel_mse), number(floor.standard_error));
    match variant.is_off() {
        false => format!(
            "  no evidence against convergence to the reference (relMSE floor {rel_mse} ± {error})\n"
        ),
        true => format!(
            "  does NOT converge to the reference: relMSE {rel_mse} ± {error} remains at any number of samples.\n  \
             Pictures or reference are biased, or the reference contains that much unreported noise\n"
        ),
    }
}

/// Every variant's efficiency relative to the first.
fn winner(e: &Convergence) -> String {
    let name = |v: &VariantRecord| v.name.clone();
    let width = e.variants.iter().map(|v| v.name.chars().count()).max();
    let width = width.unwrap_or(0);
    let first = e.variants.first().map(name).unwrap_or_default();
    let mut text = format!("efficiency, 1/(relMSE·s), relative to {first} (95 % interval)\n");
    for variant in &e.variants[1..] {
        let ratio = variant.against_first.map_or(NONE.to_owned(), |r| {
            let verdict = match () {
                () if r.low > 1.0 => "better",
                () if r.high < 1.0 => "worse",
                () => "no significant difference",
            };
            format!("×{} ({})  {verdict}", number(r.value), between(&r))
        });
        text += &format!("  {:<width$}  {ratio}\n", variant.name);
    }
    text + different_limits(e)
}

/// A remark for varying model settings.
pub fn different_limits(e: &Convergence) -> &'static str {
    match (e.models_differ, e.own_references) {
        (false, _) => "",
        (true, true) => {
            "model settings vary: the pictures converge to different limits, each compared with its own reference\n"
        }
        (true, false) => {
            "model settings vary: the pictures converge to different limits, and the reference matches at most one\n"
        }
    }
}
