//! Diagnostics of a file. miette draws them, with the line shown and the culprit underlined.

use std::fmt;
use std::sync::Arc;

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, Severity, SourceCode,
};

/// A range within one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Counted from 1.
    pub line: usize,
    /// Counted from 1, in characters; a tab is one.
    pub column: usize,
    /// First byte in the text as displayed.
    pub start: usize,
    /// In bytes; 0 means the gap before `start`.
    pub length: usize,
}

impl Place {
    /// From the start of `self` to the end of `last`, which is on the same line.
    pub(super) fn to(self, last: Place) -> Place {
        Place {
            length: last.start + last.length - self.start,
            ..self
        }
    }
}

/// An error, a warning or a note.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    pub severity: Severity,
    /// The problem.
    pub message: String,
    /// Shown under the culprit.
    pub label: String,
    /// How to fix it.
    pub help: Option<String>,
    /// The culprit; `None` if it is the whole file.
    pub place: Option<Place>,
    pub(super) source: Arc<NamedSource<String>>,
}

impl Diagnostic {
    /// The text of the culprit.
    pub fn culprit(&self) -> Option<&str> {
        let Place { start, length, .. } = self.place?;
        self.source.inner().get(start..start + length)
    }

    /// The file's name.
    pub fn file(&self) -> &str {
        self.source.name()
    }

    /// The line with the culprit underlined, as a terminal without colours shows it.
    pub fn drawn(&self) -> String {
        let theme = GraphicalTheme::unicode_nocolor();
        let handler = GraphicalReportHandler::new_themed(theme).with_links(false);
        let mut text = String::new();
        match handler.render_report(&mut text, self) {
            Ok(()) => text,
            Err(fmt::Error) => self.message.clone(),
        }
    }

    /// Adds advice on how to fix it.
    pub(super) fn help(&mut self, help: impl Into<String>) {
        self.help = Some(help.into());
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Diagnostic {}

impl miette::Diagnostic for Diagnostic {
    fn severity(&self) -> Option<Severity> {
        Some(self.severity)
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as _)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.place.map(|_| &self.source as _)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.place?;
        let label = Some(self.label.clone()).filter(|label| !label.is_empty());
        Some(Box::new(std::iter::once(LabeledSpan::new(
            label,
            place.start,
            place.length,
        ))))
    }
}

/// All diagnostics of one file, in file order; at least one is an error.
#[derive(Clone, Debug)]
pub struct Errors {
    pub diagnostics: Vec<Diagnostic>,
    pub(super) name: String,
    /// Number of warnings that became errors at the caller's request.
    pub(super) promoted: usize,
    /// The cause is a lack of memory, not a fault of the file.
    pub lacks_memory: bool,
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
        let count = |of: Severity| {
            let all = self.diagnostics.iter();
            all.filter(|d| d.severity == of).count()
        };
        let (errors, warnings) = (count(Severity::Error), count(Severity::Warning));
        write!(f, "{}: {}", self.name, plural(errors, "error"))?;
        if self.promoted > 0 {
            write!(
                f,
                ", including {} by --strict",
                plural(self.promoted, "warning")
            )?;
        }
        if warnings > 0 {
            write!(f, ", {}", plural(warnings, "warning"))?;
        }
        Ok(())
    }
}

impl std::error::Error for Errors {}

impl miette::Diagnostic for Errors {
    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn miette::Diagnostic> + 'a>> {
        Some(Box::new(self.diagnostics.iter().map(|d| d as _)))
    }
}
