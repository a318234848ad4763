//! `vkpt converge`: how fast a scene converges under various settings.

mod arguments;
mod experiment;
mod finish;
mod kept;
mod outputs;
mod page;
mod progress;
mod record;
mod reference;
mod variants;
mod vary;

use self::experiment::Experiment;
use self::variants::Variants;
use crate::cli::console::Console;
use crate::cli::destination::all_written;
use crate::cli::exit::{Ending, Failure, note, warn};
use crate::cli::inputs::spare;
use crate::cli::writable;
use crate::converge::ConvergeError;
use crate::converge::report::{Convergence, concerns, table};
pub use arguments::ConvergeArguments;

/// Renders replicates of every variant, judges them and reports the result.
pub fn converge(arguments: &ConvergeArguments) -> Result<Ending, Failure> {
    let _claims = writable::check(outputs::files(arguments))?;
    let variants = Variants::new(arguments)?;
    spare(&variants.inputs, outputs::files(arguments))?;
    spare(&reference::inputs(arguments), outputs::files(arguments))?;
    let Some(experiment) = Experiment::run(arguments, &variants)? else {
        warn("interrupted while rendering the reference: no results");
        return Ok(Ending::Interrupted);
    };
    let record = experiment.record(arguments, &variants);
    let printed = match arguments.quiet {
        true => Ok(()),
        false => Console::beside(outputs::files(arguments)).print(&table(&record)),
    };
    concerns(&record).iter().for_each(|concern| warn(concern));
    if experiment.denoises && !arguments.quiet {
        note(
            "denoised pictures converge to a biased picture: more samples reduce the bias only slowly, and noise does not show it",
        );
    }
    let (references, measured) = (&experiment.references, &experiment.measured);
    let parts = page::parts(arguments, &variants, references, measured);
    let written = outputs::write(arguments, &parts.sheet(&record));
    all_written(written.into_iter().chain([printed]))?;
    if measured.interrupted {
        warn("interrupted: the unfinished step is not reported");
        return Ok(Ending::Interrupted);
    }
    Ok(Ending::Complete)
}

/// The same for a calling program, without files: `None` if it was interrupted before the references were ready.
pub fn converged(arguments: &ConvergeArguments) -> Result<Option<Convergence>, Failure> {
    let variants = Variants::new(arguments)?;
    let experiment = Experiment::run(arguments, &variants)?;
    let record = experiment.map(|experiment| experiment.record(arguments, &variants));
    let concerns = record.as_ref().map(concerns).unwrap_or_default();
    concerns.iter().for_each(|concern| warn(concern));
    Ok(record)
}

impl From<ConvergeError> for Failure {
    fn from(error: ConvergeError) -> Self {
        match error {
            ConvergeError::Render(error) => Self::Render(error),
            ConvergeError::Metrics(error) => Self::Pictures(vec![error.to_string()]),
            ConvergeError::Finish(why) => Self::Pictures(vec![why]),
        }
    }
}
