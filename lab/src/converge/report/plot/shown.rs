//! The parts of an experiment that the plot shows.

use std::ops::Range;

use super::axes::span;
use crate::converge::report::{Convergence, StepRecord, VariantRecord};
use vkpt::metrics::convergence::Interval;

/// √relMSE with its interval, where it has a logarithm; the lower end may be 0.
pub fn error(step: &StepRecord) -> Option<Interval> {
    let rel_mse = step.errors.rel_mse.summary.mean;
    (rel_mse.value > 0.0).then(|| rel_mse.map(|e| e.max(0.0).sqrt()))
}

/// The seconds and errors that the axes show. Ends of intervals count as far as they do not press the curves together.
pub fn spans(e: &Convergence) -> [Range<f64>; 2] {
    let steps = || e.variants.iter().flat_map(|v| &v.steps);
    let shown = steps().filter_map(|s| Some((s.wall_s.value, error(s)?)));
    let ends = |i: Interval| [i.value, i.low.max(i.value / 2.0), i.high.min(i.value * 3.0)];
    let errors = shown.clone().flat_map(|(_, error)| ends(error));
    let least = errors.clone().fold(f64::INFINITY, f64::min);
    let own = e.variants.iter().filter_map(own_error);
    let near = own.filter(|&own| own > least / 4.0);
    [
        span(shown.map(|(seconds, _)| seconds)),
        span(errors.chain(near)),
    ]
}

/// The reference's own error, as √relMSE.
fn own_error(variant: &VariantRecord) -> Option<f64> {
    let own = variant.reference.own.rel_mse?;
    (own > 0.0).then(|| own.sqrt())
}

/// Those within the span, each once.
pub fn own_errors(e: &Convergence, span: &Range<f64>) -> Vec<f64> {
    let within = e.variants.iter().filter_map(own_error);
    let mut own: Vec<f64> = within.filter(|own| span.contains(own)).collect();
    own.sort_by(f64::total_cmp);
    own.dedup();
    own
}
