//! The verdict, the failures, and the results of each group.

use maud::{Markup, html};

use super::super::words::margin;
use super::super::{CaseRecord, Check, Held};
use super::colours::band;
use vkpt::report::human::{duration, plural};

/// The most important results, first.
pub fn findings(check: &Check) -> Markup {
    let failed: Vec<&CaseRecord> = check.cases.iter().filter(|c| !c.passed).collect();
    html! {
        section #findings {
            p.verdict.bad[!failed.is_empty()] { (verdict(check.cases.len(), failed.len())) }
            @if check.interrupted { p.bad { "Interrupted: the remaining cases did not run." } }
            @if check.quick { p.muted { "A quick run, without the cases that take seconds." } }
            @if !failed.is_empty() {
                h2 { "Failures" }
                ul.failures { @for case in &failed { (failure(case)) } }
            }
            (groups(check))
        }
    }
}

/// How many cases fail of how many, in words.
pub fn verdict(cases: usize, failed: usize) -> String {
    match (cases, failed) {
        (0, _) => "No case ran.".to_owned(),
        (1, 0) => "The only case is within its bounds.".to_owned(),
        (n, 0) => format!("All {n} cases are within their bounds."),
        (1, _) => "The only case fails.".to_owned(),
        (n, 1) => format!("1 of {n} cases fails."),
        (n, k) => format!("{k} of {n} cases fail."),
    }
}

fn failure(case: &CaseRecord) -> Markup {
    let beyond: Vec<&Held> = case.held.iter().filter(|h| !h.passed()).collect();
    html! {
        li {
            a href=(format!("#{}", case.name)) { (case.name) }
            span.muted { ", " (case.about) ": " }
            @for (i, held) in beyond.iter().enumerate() {
                @if i > 0 { ", " }
                (held.what) " " span.margin.(band(held.margin)) { "× " (margin(held.margin)) }
            }
        }
    }
}

fn groups(check: &Check) -> Markup {
    let parts: Vec<&[CaseRecord]> = check
        .cases
        .chunk_by(|a, b| a.group() == b.group())
        .collect();
    html! {
        div.scroll {
            table.groups {
                thead { tr {
                    th.words { "group" } th { "cases" } th { "fail" } th { "largest margin" } th { "time" }
                } }
                tbody { @for cases in parts { (group(cases)) } }
            }
        }
    }
}

fn group(cases: &[CaseRecord]) -> Markup {
    let name = cases[0].group();
    let failed = cases.iter().filter(|c| !c.passed).count();
    let largest = cases.iter().map(|c| c.margin).fold(0.0, f64::max);
    let seconds: f64 = cases.iter().map(|c| c.seconds).sum();
    html! {
        tr {
            th.words scope="row" { a href=(format!("#group-{name}")) { (name) } }
            td { (cases.len()) }
            td.bad[failed > 0] { (failed) }
            td.margin.(band(largest)) { (margin(largest)) }
            td { (duration(seconds)) }
        }
    }
}

/// `12 cases, none fails, margins up to 0.71`
pub fn in_short(cases: &[super::Row]) -> String {
    let failed = cases.iter().filter(|(c, _)| !c.passed).count();
    let largest = cases.iter().map(|(c, _)| c.margin).fold(0.0, f64::max);
    let fail = match failed {
        0 => "none fails".to_owned(),
        1 => "one fails".to_owned(),
        n => format!("{n} fail"),
    };
    let cases = plural(cases.len() as u64, "case");
    format!("{cases}, {fail}, margins up to {}", margin(largest))
}
