//! The row of a case: its figures, and a name that opens the details.

use maud::{Markup, html};

use super::super::CaseRecord;
use super::super::words::{decisive, margin, relative, share, short, worst};
use super::colours::band;
use vkpt::report::human::{duration, thousands};

/// Columns of the table.
pub const COLUMNS: usize = 12;

/// Their heads.
pub fn heads() -> Markup {
    html! {
        thead { tr {
            th.words { "case" }
            th.words.about { "description" }
            th { "margin" }
            th.words { "by" }
            th { "diverged" } th { "99 %" } th { "worst" }
            th { "broken" }
            th { "weight" }
            th { "mean" } th { "expected" }
            th { "time" }
        } }
    }
}

/// Initially open if the case fails and `opens` is set.
pub fn figures(case: &CaseRecord, opens: bool) -> Markup {
    let (_, name) = case.name.split_once('/').unwrap_or(("", &case.name));
    html! {
        tr id=(case.name) {
            th.words scope="row" {
                details open[opens && !case.passed] { summary { (breakable(name)) } }
            }
            td.words.about { (case.about) }
            td.margin.(band(case.margin)) {
                (margin(case.margin))
                @if !case.passed { " fails" }
            }
            td.words { (decisive(case).map_or("–", |held| held.what)) }
            td { (share(case.diverged, case.samples)) }
            td { (relative(case.p99)) }
            td { (relative(worst(case))) }
            td { (thousands(case.broken())) }
            td { (short(case.largest)) }
            td { (short(case.mean)) }
            td { (case.expected.map_or("–".to_owned(), short)) }
            td { (duration(case.seconds)) }
        }
    }
}

/// A name that may be broken after each slash.
fn breakable(name: &str) -> Markup {
    html! {
        @for (i, part) in name.split('/').enumerate() {
            @if i > 0 { "/" wbr; }
            (part)
        }
    }
}
