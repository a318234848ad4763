//! The results of `vkpt test`: scenes, each compared with its expected picture.

mod junit;
mod page;
mod text;

pub use junit::junit;
pub use page::page;
pub use text::{line, sum};

use vkpt::film::Film;

/// All scenes of a folder that were rendered, in order.
#[derive(Clone, Debug, Default)]
pub struct Suite {
    pub cases: Vec<Case>,
}

/// A scene.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its file, relative to the folder, with `/` between names.
    pub name: String,
    pub seconds: f64,
    pub verdict: Verdict,
    /// The files written to show the difference.
    pub files: Vec<String>,
    /// The pictures, if they differ.
    pub shown: Option<Shown>,
}

/// Pictures that differ.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The expected one.
    pub expected: Film,
    pub actual: Film,
    /// The relMSE of each pixel as a colour, if the sizes are equal.
    pub heat: Option<Film>,
}

/// The result of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The expected picture, to the bit.
    Same,
    /// Another picture, within the allowed relMSE.
    Close { rel_mse: f64 },
    /// It is now kept as expected; there was another before, or none.
    Kept { instead: bool },
    /// Another picture, and how it differs.
    Differs(String),
    /// No comparison was possible, and why.
    Failed(String),
}

impl Verdict {
    /// The error, if any.
    pub fn wrong(&self) -> Option<&str> {
        match self {
            Self::Same | Self::Close { .. } | Self::Kept { .. } => None,
            Self::Differs(why) | Self::Failed(why) => Some(why),
        }
    }
}

impl Suite {
    /// The number of failures.
    pub fn wrong(&self) -> usize {
        let wrong = self.cases.iter().filter(|c| c.verdict.wrong().is_some());
        wrong.count()
    }
}
