//! `vkpt check`: the battery of stiff and extreme cases.

mod arguments;
mod outputs;

use crate::check::both::bidirectional;
use crate::check::measure::CheckError;
use crate::check::report::{Check, Sheet, failures, table};
use crate::check::run::{Bench, run};
use crate::check::select::select;
use crate::check::{Case, battery};
use crate::cli::command::typed;
use crate::cli::console::Console;
use crate::cli::destination::all_written;
use crate::cli::exit::{Ending, Failure, warn};
use crate::cli::integrator::no_eye_paths;
use crate::cli::interrupt::stop_flag;
use crate::cli::progress::Display;
use crate::cli::writable;
pub use arguments::CheckArguments;
use vkpt::gpu::{Device, DeviceKind, Selector};
use vkpt::render::KernelChoice;
use vkpt::settings::Integrator;

/// Runs the cases, prints the table and reports failures.
pub fn check(arguments: &CheckArguments) -> Result<Ending, Failure> {
    let all = match arguments.integrator {
        Integrator::Path => battery(),
        Integrator::Bidirectional => bidirectional(battery()),
        Integrator::Light => return Err(no_eye_paths("vkpt check")),
    };
    let selected = select(&all, arguments.case.as_deref(), arguments.quick);
    if selected.is_empty() {
        return Err(unknown(arguments, &all));
    }
    let _claims = writable::check(outputs::files(arguments))?;
    let selector = arguments.device.clone().unwrap_or(Selector::Best);
    let device = Device::open(&selector).map_err(|e| Failure::Render(e.into()))?;
    let stop = stop_flag();
    let bench = Bench {
        device: &device,
        kernel: KernelChoice::Composed,
        quick: arguments.quick,
        correctly_rounded: device.info().kind == DeviceKind::Cpu,
        stop: &stop,
    };
    let mut display = Display::new(arguments.quiet);
    let ran = run(&all, &selected, &bench, &mut |i, case| {
        display.case(i, selected.len(), &case.name)
    });
    display.finish();
    let record = &ran.record;
    let printed = match arguments.quiet {
        true => Ok(()),
        false => Console::beside(outputs::files(arguments)).print(&text(record)),
    };
    let sheet = Sheet {
        record,
        command: typed(),
        shown: &ran.shown,
    };
    all_written(
        outputs::write(arguments, &sheet)
            .into_iter()
            .chain([printed]),
    )?;
    ending(record, ran.error)
}

/// No case matches the command line.
fn unknown(arguments: &CheckArguments, all: &[Case]) -> Failure {
    let mut groups: Vec<&str> = all.iter().map(Case::group).collect();
    groups.dedup();
    let name = arguments.case.as_deref().unwrap_or_default();
    Failure::Usage(format!(
        "--case '{name}' matches no case; the groups are {}",
        groups.join(", ")
    ))
}

fn text(record: &Check) -> String {
    format!("{}, {}\n\n{}", record.device, record.driver, table(record))
}

fn ending(record: &Check, error: Option<CheckError>) -> Result<Ending, Failure> {
    let mut failures = failures(record);
    failures.extend(error.map(|e| format!("{e}: the remaining cases did not run")));
    match failures {
        failures if !failures.is_empty() => Err(Failure::Comparison(failures)),
        _ if record.interrupted => {
            warn("interrupted: the remaining cases did not run");
            Ok(Ending::Interrupted)
        }
        _ => Ok(Ending::Complete),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::report::{Held, fixture};
    use vkpt::gpu::GpuError;

    fn record(nan: u64, interrupted: bool) -> Check {
        let held = vec![Held::new("NaN", nan as f64, 0.0, "none")];
        fixture::check(vec![fixture::case("a/b", held)], interrupted)
    }

    #[test]
    fn a_failure_ends_with_1_and_an_interruption_with_130() {
        assert!(matches!(
            ending(&record(0, false), None),
            Ok(Ending::Complete)
        ));
        assert!(matches!(
            ending(&record(0, true), None),
            Ok(Ending::Interrupted)
        ));
        for interrupted in [false, true] {
            let failed = ending(&record(1, interrupted), None);
            assert!(matches!(failed, Err(Failure::Comparison(printed)) if printed.len() == 1));
        }
        let lost = CheckError::Render("a/c".to_owned(), GpuError::Lost.into());
        let failed = ending(&record(1, true), Some(lost));
        assert!(matches!(failed, Err(Failure::Comparison(printed)) if printed.len() == 2));
    }
}
