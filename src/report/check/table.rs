//! The table of `vkpt check`, and what its failures mean.

use super::record::{CaseRecord, Check, Held};
use crate::report::human::{duration, plural, thousands};

/// Heads of the columns after the name, and their widths: 100 columns in all.
const COLUMNS: [(&str, usize); 8] = [
    ("samples", 10),
    ("parted", 7),
    ("99 %", 8),
    ("worst", 8),
    ("weight", 8),
    ("mean", 8),
    ("margin", 7),
    ("time", 7),
];
const NAME: usize = 31;
const MARK: usize = 6;

/// A line a case, below the name of its group; then how many failed.
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
    let light = |x: Option<f64>| x.map_or("–".to_owned(), small);
    [
        thousands(case.samples),
        thousands(case.parted),
        light(case.p99),
        light(case.worst.or(case.p99.map(|_| 0.0))),
        plain(case.largest),
        plain(case.mean),
        margin(case.margin),
        duration(case.seconds),
    ]
}

/// `0.25`, `6.2e3`, `∞`.
fn margin(x: f64) -> String {
    match x {
        x if x < 1000.0 => format!("{x:.2}"),
        x if x.is_finite() => small(x),
        _ => "∞".to_owned(),
    }
}

/// `0`, `3.1e-7`.
fn small(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else {
        format!("{x:.1e}")
    }
}

/// `0.8340`, `2.25`, `3.1e9`: five digits at most.
fn plain(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        a if (1e-2..1e4).contains(&a) => {
            format!("{x:.*}", (4.0 - a.log10().floor().max(0.0)) as usize)
        }
        _ => format!("{x:.3e}"),
    }
}

fn sum(check: &Check) -> String {
    let failed = check.cases.iter().filter(|c| !c.passed).count();
    let failed = match failed {
        0 => "none fails".to_owned(),
        1 => "1 fails".to_owned(),
        n => format!("{n} fail"),
    };
    format!(
        "\n{}, {failed}, {}\n",
        plural(check.cases.len() as u64, "case"),
        duration(check.seconds)
    )
}

/// What each case that fails fails by, with what that means.
pub fn failures(check: &Check) -> Vec<String> {
    let failed = check.cases.iter().filter(|c| !c.passed);
    failed
        .map(|case| {
            let by: Vec<String> = case.held.iter().filter(|h| !h.passed()).map(told).collect();
            format!("{}: {}\n{}", case.name, case.about, by.join("\n"))
        })
        .collect()
}

fn told(held: &Held) -> String {
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
