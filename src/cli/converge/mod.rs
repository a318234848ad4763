//! `vkpt converge`: how fast a scene converges, and by which settings faster.

mod arguments;
mod finish;
mod kept;
mod outputs;
mod page;
mod record;
mod reference;
mod variants;
mod vary;

use std::sync::atomic::AtomicBool;

use self::finish::{Finisher, finishers};
use self::reference::References;
use self::variants::Variants;
use super::console::Console;
use super::destination::all_written;
use super::exit::{Ending, Failure, note, warn};
use super::inputs::spare;
use super::interrupt::stop_flag;
use super::progress::Display;
use super::writable;
use crate::converge::{Measured, Plan, Variant, measure};
use crate::film::Film;
use crate::metrics::flip::Viewing;
use crate::render::{Engine, Job};
use crate::report::convergence::{concerns, table};
pub use arguments::ConvergeArguments;

/// Renders replicates of every variant, judges them and tells what came out.
pub fn converge(arguments: &ConvergeArguments) -> Result<Ending, Failure> {
    let _claims = writable::check(outputs::files(arguments))?;
    let plan = Plan {
        seeds: arguments.seeds()?,
        seconds: arguments.time,
        spp: arguments.spp,
        viewing: Viewing {
            exposure: arguments.exposure,
            ..Viewing::default()
        },
    };
    let variants = Variants::new(arguments)?;
    spare(&variants.inputs, outputs::files(arguments))?;
    spare(&reference::inputs(arguments), outputs::files(arguments))?;
    let given = reference::given(arguments, variants.size(arguments))?;
    let engine = Engine::open(&arguments.target()).map_err(Failure::Render)?;
    let stop = stop_flag();
    let jobs = variants.jobs(arguments);
    let Some(references) = References::new(given, &jobs, &engine, &plan, &stop, arguments.quiet)?
    else {
        warn("interrupted while the reference was rendered: nothing is told");
        return Ok(Ending::Interrupted);
    };
    let finishers = finishers(&variants.combinations, &jobs, arguments.oidn.as_deref())?;
    let measured = run(
        &jobs,
        &finishers,
        &references,
        &engine,
        &plan,
        &stop,
        arguments.quiet,
    )?;
    let record = record::record(arguments, &variants, &references, &engine, &measured);
    let told = match arguments.quiet {
        true => Ok(()),
        false => Console::beside(outputs::files(arguments)).print(&table(&record)),
    };
    concerns(&record).iter().for_each(|concern| warn(concern));
    if finishers.iter().any(Option::is_some) && !arguments.quiet {
        note(
            "denoised pictures converge elsewhere: they keep an error that samples take away but slowly, and no noise tells of",
        );
    }
    let parts = page::parts(arguments, &variants, &references, &measured);
    let written = outputs::write(arguments, &parts.sheet(&record));
    all_written(written.into_iter().chain([told]))?;
    if measured.interrupted {
        warn("interrupted: the step under way is not told");
        return Ok(Ending::Interrupted);
    }
    Ok(Ending::Complete)
}

fn run(
    jobs: &[Job],
    finishers: &[Option<Finisher>],
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
        display.experiment(p)
    });
    display.finish();
    Ok(measured?)
}
