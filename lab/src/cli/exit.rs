//! The end of the program, and its messages on stderr.

use miette::Severity;

use super::caller::caller;
pub use super::failure::{Ending, Failure, MEMORY};
use super::interrupt::exit_code;
use super::streams::print_line;
use vkpt::scene::Diagnostic;

/// Prints a failure and returns the program's exit code.
pub fn exit(ending: Result<Ending, Failure>) -> u8 {
    match ending {
        Ok(Ending::Complete) => 0,
        Ok(Ending::Interrupted) => exit_code(),
        Ok(Ending::Undenoised) => 1,
        Err(failure) => {
            let code = failure.code();
            print_failure(failure);
            code
        }
    }
}

/// Prints a failure.
fn print_failure(failure: Failure) {
    match failure {
        Failure::Usage(message) => {
            error(&format!("{message}\n\nFor more information, try '--help'."))
        }
        // If that fails, nothing can report it.
        Failure::CommandLine(wrong) => drop(wrong.print()),
        Failure::Scene(errors) => {
            let sum = errors.to_string();
            point_out(errors.diagnostics);
            error(&sum);
        }
        other => other.messages().iter().for_each(|message| error(message)),
    }
}

/// A diagnostic with its place, on one line.
fn placed(diagnostic: &Diagnostic) -> String {
    let file = diagnostic.file();
    match diagnostic.place {
        Some(place) => format!("{file}:{}: {diagnostic}", place.line),
        None => diagnostic.to_string(),
    }
}

fn error(message: &dyn std::fmt::Display) {
    print_line(format!("error: {message}"));
}

/// Prints a warning, or passes it to the caller.
pub fn warn(message: &str) {
    match caller() {
        Some(by) => by.caller.borrow_mut().warn(message),
        None => print_line(format!("warning: {message}")),
    }
}

/// Prints a note, on the command line only.
pub fn note(message: &str) {
    if caller().is_none() {
        print_line(format!("note: {message}"));
    }
}

/// The most diagnostics to print: more are not worth reading before some are fixed. Drawing each reads the whole file.
const MOST: usize = 20;

/// Shows the diagnostics of a scene file: the line, with the culprit underlined. If there are too many, errors precede
/// warnings.
pub fn point_out(mut diagnostics: Vec<Diagnostic>) {
    if caller().is_some() {
        let warnings = diagnostics
            .iter()
            .filter(|d| d.severity == Severity::Warning);
        warnings.for_each(|d| warn(&placed(d)));
        return;
    }
    let all = diagnostics.len();
    if all > MOST {
        diagnostics.sort_by_key(|d| d.severity != Severity::Error);
        diagnostics.truncate(MOST);
    }
    for diagnostic in diagnostics {
        print_line(format!("{:?}", miette::Report::new(diagnostic)));
    }
    if all > MOST {
        print_line(format!("… and {} more\n", all - MOST));
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::rc::Rc;
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;

    use super::*;
    use crate::cli::caller::{Called, Caller, called};
    use crate::cli::interrupt::stop_flag;

    #[derive(Default)]
    struct Ears(Vec<String>);

    impl Caller for Ears {
        fn warn(&mut self, message: &str) {
            self.0.push(message.to_owned());
        }

        fn progress(&mut self, _: f64, _: &dyn Fn() -> String) {}
    }

    #[test]
    fn a_caller_hears_its_own_command_and_stops_it() {
        let [outer, inner] = [(); 2].map(|()| Rc::new(RefCell::new(Ears::default())));
        let stop = Arc::new(AtomicBool::new(true));
        let by = |caller: &Rc<RefCell<Ears>>| Called {
            caller: caller.clone(),
            stop: stop.clone(),
        };
        called(by(&outer), || {
            warn("one");
            called(by(&inner), || warn("two"));
            note("none of its business");
            warn("three");
            assert!(Arc::ptr_eq(&stop_flag(), &stop));
        });
        assert!(caller().is_none());
        assert!(!Arc::ptr_eq(&stop_flag(), &stop));
        assert_eq!(outer.borrow().0, ["one", "three"]);
        assert_eq!(inner.borrow().0, ["two"]);
    }
}
