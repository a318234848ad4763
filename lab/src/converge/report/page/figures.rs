//! Every figure of every step.

use maud::{Markup, html};

use super::super::words::{NONE, between, marked, number, own, reached, with_half_width};
use super::super::{Convergence, ErrorRecord, StepRecord, VariantRecord};
use super::name;
use vkpt::metrics::convergence::Metric;
use vkpt::report::human::duration;

/// A table for each variant; those of the other metrics are folded.
pub fn figures(e: &Convergence) -> Markup {
    html! {
        section #figures {
            h2 { "All figures" }
            p.note {
                "Mean of the replicates with its 95 % interval (Student’s t). Trimmed: without the worst 1 % of each replicate’s pixels. \
                 Median: of the replicates. Slope: of relMSE over samples, −1 for independent samples. Efficiency: 1/(relMSE·s)."
            }
            @for variant in &e.variants {
                @if e.variants.len() > 1 { h3 { (name(variant)) } }
                (of_variant(variant))
            }
        }
    }
}

fn of_variant(variant: &VariantRecord) -> Markup {
    let mark = |s: &StepRecord| {
        Metric::ALL
            .iter()
            .any(|&(m, _)| s.errors.of(m).below_reference)
    };
    html! {
        (table(variant, &[Metric::RelMse], true))
        ul.note {
            @if variant.steps.iter().any(mark) {
                li { "* not above the reference’s own error: inconclusive" }
            }
            li { "reference: " (variant.reference.name) "; " (own(&variant.reference.own)) }
            li { (duration(variant.set_up_s)) " of set-up before the first sample, included only in the times “with set-up”" }
            @for reach in &variant.reach { li { (reached(reach)) } }
        }
        details {
            summary { "MSE, RMSE, SMAPE and FLIP" }
            (table(variant, &[Metric::Mse, Metric::Rmse], false))
            (table(variant, &[Metric::Smape, Metric::Flip], false))
        }
    }
}

/// A row for each step. Figures that depend on time are shown with relMSE, `timed`.
fn table(variant: &VariantRecord, metrics: &[Metric], timed: bool) -> Markup {
    html! {
        div.scroll {
            table.figures {
                thead {
                    tr {
                        th {}
                        @if timed { th colspan="3" { "seconds of sampling" } }
                        @for &metric in metrics { th.group colspan="4" { (title(metric)) } }
                        @if timed { th.group colspan="2" {} }
                    }
                    tr {
                        th { "spp" }
                        @if timed { th { "wall" } th { "with set-up" } th { "GPU" } }
                        @for _ in metrics { th.group { "mean" } th { "95 %" } th { "trimmed" } th { "median" } }
                        @if timed { th.group { "slope" } th { "efficiency" } }
                    }
                }
                tbody { @for step in &variant.steps { (row(step, metrics, timed)) } }
            }
        }
    }
}

fn title(metric: Metric) -> &'static str {
    let of = |&&(other, _): &&(Metric, &'static str)| other == metric;
    Metric::ALL.iter().find(of).map_or("", |(_, title)| title)
}

fn row(step: &StepRecord, metrics: &[Metric], timed: bool) -> Markup {
    let or_none = |text: Option<String>| text.unwrap_or(NONE.to_owned());
    html! {
        tr {
            th scope="row" { (step.spp) }
            @if timed {
                td { (duration(step.wall_s.value)) }
                td { (duration(step.wall_with_set_up_s)) }
                td { (or_none(step.gpu_s.map(|s| duration(s.value)))) }
            }
            @for &metric in metrics { (error(step.errors.of(metric))) }
            @if timed {
                td.group { (or_none(step.slope.map(|s| with_half_width(&s)))) }
                td { (or_none(step.efficiency.map(|i| number(i.value)))) }
            }
        }
    }
}

fn error(error: &ErrorRecord) -> Markup {
    let summary = &error.summary;
    html! {
        td.group { (marked(error)) }
        td { (between(&summary.mean)) }
        td { (number(summary.trimmed)) }
        td { (number(summary.median_of_means)) }
    }
}
