//! The results, a row for each variant.

use maud::{Markup, html};

use super::super::table::different_limits;
use super::super::words::{NONE, between, marked, number};
use super::super::{Convergence, ReachRecord, VariantRecord, concerns};
use super::name;
use vkpt::metrics::convergence::Reach;
use vkpt::report::human::duration;

/// The error and speed of each variant, and whether it converges to the reference.
pub fn findings(e: &Convergence) -> Markup {
    let several = e.variants.len() > 1;
    html! {
        section #findings {
            @if e.interrupted {
                p.bad { "Interrupted: the unfinished step is not shown." }
            }
            @if several && !different_limits(e).is_empty() {
                p.bad { (different_limits(e).trim()) }
            }
            div.scroll {
                table.findings {
                    thead {
                        tr {
                            @if several { th {} }
                            th colspan="3" { "at the last step" }
                            th.group colspan="2" { "seconds to relMSE" }
                            @if several { th.group colspan="2" { "relative efficiency" } }
                            th.group colspan="2" { "remaining error" }
                        }
                        tr {
                            @if several { th.words { "variant" } }
                            th { "spp" } th { "relMSE" } th { "95 %" }
                            @for (i, reach) in first_reach(e).iter().enumerate() {
                                th.group[i == 0] { (format!("{:e}", reach.rel_mse)) }
                            }
                            @if several { th.group { "ratio" } th { "95 %" } }
                            th.group { "relMSE" } th.words { "converges?" }
                        }
                    }
                    tbody { @for variant in &e.variants { (row(variant, several)) } }
                }
            }
            @for concern in concerns(e) { p.bad { (concern) } }
        }
    }
}

fn first_reach(e: &Convergence) -> &[ReachRecord] {
    e.variants.first().map_or(&[], |v| &v.reach)
}

fn row(variant: &VariantRecord, several: bool) -> Markup {
    let floor = variant.floor;
    html! {
        tr {
            @if several { th.words scope="row" { (name(variant)) } }
            (last_step(variant))
            @for (i, reach) in variant.reach.iter().enumerate() {
                td.group[i == 0] { (when(reach.reach)) }
            }
            @if several { (against_first(variant)) }
            td.group {
                (floor.map_or(NONE.to_owned(), |f| format!("{} ± {}", number(f.rel_mse), number(f.standard_error))))
            }
            td.words.bad[variant.is_off()] {
                (match floor {
                    None => "unknown: two replicates",
                    Some(_) if variant.is_off() => "NO",
                    Some(_) => "nothing against it",
                })
            }
        }
    }
}

fn last_step(variant: &VariantRecord) -> Markup {
    let last = variant.steps.last();
    let cell = |text: Option<String>| text.unwrap_or(NONE.to_owned());
    html! {
        td { (cell(last.map(|s| s.spp.to_string()))) }
        td { (cell(last.map(|s| marked(&s.errors.rel_mse)))) }
        td { (cell(last.map(|s| between(&s.errors.rel_mse.summary.mean)))) }
    }
}

fn against_first(variant: &VariantRecord) -> Markup {
    let ratio = variant.against_first;
    html! {
        td.group { (ratio.map_or(NONE.to_owned(), |r| format!("×{}", number(r.value)))) }
        td { (ratio.map_or(NONE.to_owned(), |r| between(&r))) }
    }
}

fn when(reach: Reach) -> String {
    match reach {
        Reach::Before(seconds) => format!("≤ {}", duration(seconds)),
        Reach::At(seconds) => duration(seconds),
        Reach::Extrapolated(seconds) => format!("≈ {}", duration(seconds)),
        Reach::Never => "not reached".to_owned(),
    }
}
