//! Gathers what is wrong with a file while it is read.

use std::path::Path;
use std::sync::Arc;

use miette::{NamedSource, Severity};

use super::diagnostic::{Diagnostic, Errors, Place};

/// Gathers the diagnostics of a file.
pub(super) struct Log {
    name: String,
    source: Arc<NamedSource<String>>,
    diagnostics: Vec<Diagnostic>,
    errors: usize,
    /// One of them is that memory does not suffice.
    pub lacks_memory: bool,
}

impl Log {
    /// For the file `path` that holds `text`.
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

    /// Notes an error; `label` is said under the culprit.
    pub fn error(&mut self, place: Place, message: String, label: &str) -> &mut Diagnostic {
        self.push(Severity::Error, Some(place), message, label)
    }

    /// Notes a warning; `label` is said under the culprit.
    pub fn warning(&mut self, place: Place, message: String, label: &str) -> &mut Diagnostic {
        self.push(Severity::Warning, Some(place), message, label)
    }

    /// Notes an error of the whole file, which `message` names.
    pub fn file_error(&mut self, message: String) -> &mut Diagnostic {
        self.push(Severity::Error, None, message, "")
    }

    /// Notes a warning about the whole file, which `message` names.
    pub fn file_warning(&mut self, message: String) -> &mut Diagnostic {
        self.push(Severity::Warning, None, message, "")
    }

    /// Notes what is good to know of the whole file, which `message` names: no warning, by any setting.
    pub fn file_note(&mut self, message: String) -> &mut Diagnostic {
        self.push(Severity::Advice, None, message, "")
    }

    /// An error of the whole file that ends its reading.
    pub fn fail(mut self, message: String) -> Errors {
        self.file_error(message);
        Errors {
            diagnostics: self.diagnostics,
            name: self.name,
            promoted: 0,
            lacks_memory: self.lacks_memory,
        }
    }

    /// The file's name as messages have it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How many errors there are so far.
    pub fn errors(&self) -> usize {
        self.errors
    }

    /// `whole` and the warnings, if there is no error; with `strict` a warning is one. `whole` is `None` only
    /// where an error was noted.
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
        // What concerns the whole file comes last.
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
