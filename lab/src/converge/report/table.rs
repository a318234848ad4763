//! The experiment for people: a table a variant, then which variant wins.

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
        "{}: {width}×{height}{crop}, {}, seeds {} to {last}, {} of at most {} of sampling spent\n\
         on {}, {}\n\
         mean of the replicates (95 % interval, Student's t); trimmed: without each one's worst 1 % of pixels;\n\
         median: of the replicates; slope: of relMSE over samples, −1 for independent ones\n",
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
        text += "  * no larger than what the reference itself is off by: it says nothing\n";
    }
    text += &format!(
        "  reference {}, {}\n  {} before the first sample, in no time above\n",
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

/// Columns to the right, as wide as their widest cell, two blanks before each.
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

/// Whether the pictures go where the reference is.
fn verdict(variant: &VariantRecord) -> String {
    let Some(floor) = variant.floor else {
        return String::new();
    };
    let (rel_mse, error) = (number(floor.rel_mse), number(floor.standard_error));
    match variant.is_off() {
        false => format!(
            "  nothing speaks against convergence to the reference (floor of relMSE {rel_mse} ± {error})\n"
        ),
        true => format!(
            "  does NOT converge to the reference: relMSE {rel_mse} ± {error} stays, however many samples are taken.\n  \
             Pictures or reference are biased, or the reference has as much noise that it does not tell of\n"
        ),
    }
}

/// Every variant's efficiency by the first's.
fn winner(e: &Convergence) -> String {
    let name = |v: &VariantRecord| v.name.clone();
    let width = e.variants.iter().map(|v| v.name.chars().count()).max();
    let width = width.unwrap_or(0);
    let first = e.variants.first().map(name).unwrap_or_default();
    let mut text = format!("efficiency, 1/(relMSE·s), by that of {first} (95 % interval)\n");
    for variant in &e.variants[1..] {
        let ratio = variant.against_first.map_or(NONE.to_owned(), |r| {
            let verdict = match () {
                () if r.low > 1.0 => "better",
                () if r.high < 1.0 => "worse",
                () => "no difference is shown",
            };
            format!("×{} ({})  {verdict}", number(r.value), between(&r))
        });
        text += &format!("  {:<width$}  {ratio}\n", variant.name);
    }
    text + different_limits(e)
}

/// What to know where settings of the model vary.
pub fn different_limits(e: &Convergence) -> &'static str {
    match (e.models_differ, e.own_references) {
        (false, _) => "",
        (true, true) => {
            "settings of the model vary: the pictures converge to different things, each judged by a reference of\n\
             its own\n"
        }
        (true, false) => {
            "settings of the model vary: the pictures converge to different things, and the reference can be no more\n\
             than one of them\n"
        }
    }
}
