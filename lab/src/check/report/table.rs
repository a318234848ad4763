//! The table of `vkpt check`, and explanations of failures.

use super::record::{CaseRecord, Check, Held};
use super::words::{margin, plain, relative, share, short, worst};
use vkpt::report::human::{duration, plural, thousands};

/// Heads of the columns after the name, and their widths: 100 columns in all, and the mark.
const COLUMNS: [(&str, usize); 9] = [
    ("diverged", 8),
    ("99 %", 8),
    ("worst", 8),
    ("broken", 7),
    ("weight", 8),
    ("mean", 8),
    ("expected", 9),
    ("margin", 7),
    ("time", 7),
];
const NAME: usize = 30;
const MARK: usize = 6;

/// A line for each case, below the name of its group; then the number of failures.
pub fn table(check: &Check) -> String {
    let heads = COLUMNS.map(|(head, _)| head.to_owned());
    let mut text = line("", &heads, "");
    let mut group = "";
    for case in &check.cases {
        let (of, name) = case.name.split_once('/').unwrap_or(("", &case.name));
        if of != group {
            group = of;
            text += &format!("{group}\n");
        }
        text += &line(
            &format!("  {name}"),
            &cells(case),
            if case.passed { "" } else { "FAILS" },
        );
    }
    text + &sum(check)
}

fn line(name: &str, cells: &[String; COLUMNS.len()], mark: &str) -> String {
    let cells = cells.iter().zip(COLUMNS);
    let cells: String = cells
        .map(|(cell, (_, width))| format!("{cell:>width$}"))
        .collect();
    let mark = if mark.is_empty() {
        String::new()
    } else {
        format!("{mark:>MARK$}")
    };
    format!("{name:<NAME$}{cells}{mark}").trim_end().to_owned() + "\n"
}

fn cells(case: &CaseRecord) -> [String; COLUMNS.len()] {
    [
        share(case.diverged, case.samples),
        relative(case.p99),
        relative(worst(case)),
        thousands(case.broken()),
        short(case.largest),
        short(case.mean),
        case.expected.map_or("–".to_owned(), short),
        margin(case.margin),
        duration(case.seconds),
    ]
}

fn sum(check: &Check) -> String {
    let failed = check.cases.iter().filter(|c| !c.passed).count();
    let failed = match failed {
        0 => "none fails".to_owned(),
        1 => "one fails".to_owned(),
        n => format!("{n} fail"),
    };
    format!(
        "\n{}, {failed}, {}\n",
        plural(check.cases.len() as u64, "case"),
        duration(check.seconds)
    )
}

/// The bounds that each failing case exceeds, with explanations.
pub fn failures(check: &Check) -> Vec<String> {
    let failed = check.cases.iter().filter(|c| !c.passed);
    failed
        .map(|case| {
            let by: Vec<String> = case
                .held
                .iter()
                .filter(|h| !h.passed())
                .map(bound)
                .collect();
            format!("{}: {}\n{}", case.name, case.about, by.join("\n"))
        })
        .collect()
}

fn bound(held: &Held) -> String {
    let Held {
        what,
        measured,
        bound,
        why,
        ..
    } = held;
    format!(
        "  {what}: {}, at most {}: {why}",
        plain(*measured),
        plain(*bound)
    )
}
