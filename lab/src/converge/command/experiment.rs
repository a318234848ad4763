//! The experiment itself: references, then replicates of every variant.

use std::sync::atomic::AtomicBool;

use super::arguments::ConvergeArguments;
use super::finish::{Finisher, finishers};
use super::progress;
use super::record;
use super::reference::{self, References};
use super::variants::Variants;
use crate::cli::exit::Failure;
use crate::cli::interrupt::stop_flag;
use crate::cli::progress::Display;
use crate::converge::report::Convergence;
use crate::converge::{Measured, Plan, Variant, measure};
use vkpt::film::Film;
use vkpt::metrics::flip::Viewing;
use vkpt::render::{Engine, Job};

/// The measurements and the references.
pub struct Experiment {
    pub references: References,
    pub measured: Measured,
    /// Some pictures were denoised.
    pub denoises: bool,
    engine: Engine,
}

impl Experiment {
    /// Renders and judges; `None` if it was interrupted before the references were ready.
    pub fn run(
        arguments: &ConvergeArguments,
        variants: &Variants,
    ) -> Result<Option<Self>, Failure> {
        let plan = Plan {
            seeds: arguments.seeds()?,
            seconds: arguments.time,
            spp: arguments.spp,
            viewing: Viewing {
                exposure: arguments.exposure,
                ..Viewing::default()
            },
        };
        let given = reference::given(arguments, variants.size(arguments))?;
        let engine = Engine::open(&arguments.target()).map_err(Failure::Render)?;
        let stop = stop_flag();
        let jobs = variants.jobs(arguments);
        let quiet = arguments.quiet;
        let Some(references) = References::new(given, &jobs, &engine, &plan, &stop, quiet)? else {
            return Ok(None);
        };
        let finishers = finishers(&variants.combinations, &jobs, arguments.oidn.as_deref())?;
        let finished = (&jobs[..], &finishers[..]);
        let measured = measured(finished, &references, &engine, &plan, &stop, quiet)?;
        Ok(Some(Self {
            references,
            measured,
            denoises: finishers.iter().any(Option::is_some),
            engine,
        }))
    }

    pub fn record(&self, arguments: &ConvergeArguments, variants: &Variants) -> Convergence {
        let Self {
            references,
            measured,
            engine,
            ..
        } = self;
        record::record(arguments, variants, references, engine, measured)
    }
}

/// The curves of the jobs, whose pictures may be finished before they are judged.
fn measured(
    (jobs, finishers): (&[Job], &[Option<Finisher>]),
    references: &References,
    engine: &Engine,
    plan: &Plan,
    stop: &AtomicBool,
    quiet: bool,
) -> Result<Measured, Failure> {
    let finishers = finishers.iter().map(Option::as_ref);
    let finishes: Vec<_> = finishers
        .map(|f| f.map(|f| move |picture: &Film, halves: [&Film; 2]| f.finish(picture, halves)))
        .collect();
    let variant = |(job, finish)| Variant {
        job,
        reference: &references.of(job).reference,
        finish: Option::as_ref(finish).map(|finish| finish as _),
    };
    let variants: Vec<Variant> = jobs.iter().zip(&finishes).map(variant).collect();
    let mut display = Display::new(quiet);
    let measured = measure(&variants, engine, plan, stop, &mut |p| {
        progress::show(&mut display, &p)
    });
    display.finish();
    Ok(measured?)
}
