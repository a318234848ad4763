//! The record of the measurements.

use super::arguments::ConvergeArguments;
use super::reference::References;
use super::variants::Variants;
use crate::converge::Measured;
use crate::converge::report::{Convergence, Subject, VariantRecord};
use vkpt::metrics::convergence::LEVEL;
use vkpt::render::Engine;

pub fn record(
    arguments: &ConvergeArguments,
    variants: &Variants,
    references: &References,
    engine: &Engine,
    measured: &Measured,
) -> Convergence {
    let [device, driver] = engine.name();
    let first = measured.curves.first();
    let jobs = variants.jobs(arguments);
    let variant = |i: usize| {
        let named = references.of(&jobs[i]);
        let subject = Subject {
            name: &variants.combinations[i].name,
            settings: &jobs[i].settings,
            reference: &named.reference,
            reference_name: &named.name,
        };
        VariantRecord::new(&subject, &measured.curves[i], first.filter(|_| i > 0))
    };
    Convergence {
        version: env!("CARGO_PKG_VERSION"),
        scene: arguments.scene.name(),
        size: variants.full_size(),
        crop: arguments.view.crop,
        seed: arguments.seed,
        replicates: arguments.replicates as usize,
        seconds: arguments.time,
        spent_s: measured.spent_s,
        device,
        driver,
        level: LEVEL,
        models_differ: variants.models.len() > 1,
        own_references: !references.is_given(),
        interrupted: measured.interrupted,
        variants: (0..measured.curves.len()).map(variant).collect(),
    }
}
