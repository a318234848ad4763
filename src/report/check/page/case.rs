//! The row of a case: its figures, and a name that opens what is behind them.

use maud::{Markup, html};

use super::super::CaseRecord;
use super::super::words::{decisive, margin, relative, short, worst};
use super::colours::band;
use crate::report::human::duration;

/// Columns of the table.
pub const COLUMNS: usize = 11;

/// Their heads.
pub fn heads() -> Markup {
    html! {
        thead { tr {
            th.words { "case" }
            th.words.about { "what is stiff about it" }
            th { "margin" }
            th.words { "by" }
            th { "parted" } th { "99 %" } th { "worst" }
            th { "weight" }
            th { "mean" } th { "expected" }
            th { "time" }
        } }
    }
}

/// Open from the start where it fails, if that `opens` it.
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
            td { (share(case.parted, case.samples)) }
            td { (relative(case.p99)) }
            td { (relative(worst(case))) }
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

/// `0`, `0.024 %`: two digits, for one path among millions is to be seen.
pub fn share(part: u64, of: u64) -> String {
    let percent = 100.0 * part as f64 / of.max(1) as f64;
    match percent {
        0.0 => "0".to_owned(),
        p if p < 0.001 => format!("{p:.0e} %"),
        p => {
            let decimals = (1.0 - p.log10().floor()).clamp(0.0, 4.0) as usize;
            format!("{p:.decimals$} %")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_have_two_digits() {
        let texts =
            [(0, 7), (1, 8192), (1, 100), (1, 3), (7, 7), (1, 1 << 20)].map(|(n, of)| share(n, of));
        assert_eq!(texts, ["0", "0.012 %", "1.0 %", "33 %", "100 %", "1e-4 %"]);
    }
}
