//! Collects the diagnostics of a file while it is read.

use std::path::Path;
use std::sync::Arc;

use miette::{NamedSource, Severity};

use super::diagnostic::{Diagnostic, Errors, Place};

/// The diagnostics of a file.
pub(super) struct Log {
    name: String,
    source: Arc<NamedSource<String>>,
    diagnostics: Vec<Diagnostic>,
    errors: usize,
    /// One of the errors is a lack of memory.
    pub lacks_memory: bool,
}

impl Log {
    /// An empty log of the file `path` with the content `text`.
    pub fn new(path: &Path, text: String) -> Self {
        let name = path.display().to_string();
        let source = Arc::new(NamedSource::new(&name, text));
        Self {
            name,
            source,
            diagnostics: Vec::new(),
            errors: 0,
            lacks_memory: false,
        }
    }

    /// Adds an error; `label` is shown under the culprit.
    pub fn error(&mut self, place: Place, message: String, label: &str) -> &mut Diagnostic {
        self.push(Severity::Error, Some(place), message, label)
    }

    /// Adds a warning; `label` is shown under the culprit.
    pub fn warning(&mut self, place: Place, message: String, label: &str) -> &mut Diagnostic {
        self.push(Severity::Warning, Some(place), message, label)
    }

    /// Adds an error about the whole file, which `message` names.
    pub fn file_error(&mut self, message: String) -> &mut Diagnostic {
        self.push(Severity::Error, None, message, "")
    }

    /// Adds a warning about the whole file, which `message` names.
    pub fn file_warning(&mut self, message: String) -> &mut Diagnostic {
        self.push(Severity::Warning, None, message, "")
    }

    /// Adds a note about the whole file, which `message` names. No setting turns it into a warning.
    pub fn file_note(&mut self, message: String) -> &mut Diagnostic {
        self.push(Severity::Advice, None, message, "")
    }

    /// Adds an error about the whole file that ends its reading.
    pub fn fail(mut self, message: String) -> Errors {
        self.file_error(message);
        Errors {
            diagnostics: self.diagnostics,
            name: self.name,
            promoted: 0,
            lacks_memory: self.lacks_memory,
        }
    }

    /// The file's name in messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The number of errors so far.
    pub fn errors(&self) -> usize {
        self.errors
    }

    /// `whole` and the warnings, if there are no errors; with `strict`, warnings count as errors. `whole` is `None`
    /// only where an error was logged.
    pub fn finish<T>(
        mut self,
        whole: Option<T>,
        strict: bool,
    ) -> Result<(T, Vec<Diagnostic>), Errors> {
        let mut promoted = 0;
        for warning in self
            .diagnostics
            .iter_mut()
            .filter(|d| strict && d.severity == Severity::Warning)
        {
            warning.severity = Severity::Error;
            self.errors += 1;
            promoted += 1;
        }
        // Diagnostics of the whole file come last.
        self.diagnostics
            .sort_by_key(|d| d.place.map_or(usize::MAX, |place| place.start));
        match whole {
            Some(whole) if self.errors == 0 => Ok((whole, self.diagnostics)),
            _ => Err(Errors {
                diagnostics: self.diagnostics,
                name: self.name,
                promoted,
                lacks_memory: self.lacks_memory,
            }),
        }
    }

    fn push(
        &mut self,
        severity: Severity,
        place: Option<Place>,
        message: String,
        label: &str,
    ) -> &mut Diagnostic {
        self.errors += usize::from(severity == Severity::Error);
        let (label, source) = (label.to_owned(), self.source.clone());
        self.diagnostics.push(Diagnostic {
            severity,
            message,
            label,
            help: None,
            place,
            source,
        });
        let last = self.diagnostics.len() - 1;
        &mut self.diagnostics[last]
    }
}
