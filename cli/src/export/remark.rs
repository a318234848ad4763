//! Remarks on lines of the scene: a feature that the other renderer lacks, or treats differently.

use std::fmt;

/// A line of the scene and a remark on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Remark<R> {
    pub line: usize,
    pub reason: R,
    /// Number of later lines with the same remark.
    pub more: usize,
}

impl<R> Remark<R> {
    pub fn new(line: usize, reason: R) -> Self {
        Self {
            line,
            reason,
            more: 0,
        }
    }
}

impl<R: fmt::Display> Remark<R> {
    /// The same with its reason as text.
    pub fn as_text(self) -> Remark<String> {
        Remark {
            line: self.line,
            reason: self.reason.to_string(),
            more: self.more,
        }
    }
}

impl<R: fmt::Display> fmt::Display for Remark<R> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.reason.fmt(f)?;
        match self.more {
            0 => Ok(()),
            1 => f.write_str(" (and 1 more line)"),
            n => write!(f, " (and {n} more lines)"),
        }
    }
}

/// In file order, each reason once.
pub fn gathered<R: PartialEq>(mut remarks: Vec<Remark<R>>) -> Vec<Remark<R>> {
    remarks.sort_by_key(|remark| remark.line);
    let mut gathered: Vec<Remark<R>> = Vec::new();
    for remark in remarks {
        match gathered.iter_mut().find(|r| r.reason == remark.reason) {
            Some(same) => same.more += 1,
            None => gathered.push(remark),
        }
    }
    gathered
}
