//! What `vkpt test` found: scenes, each against its kept picture.

mod junit;
mod page;
mod text;

pub use junit::junit;
pub use page::page;
pub use text::{line, sum};

use vkpt::film::Film;

/// All scenes of a folder that were tried, in their order.
#[derive(Clone, Debug, Default)]
pub struct Suite {
    pub cases: Vec<Case>,
}

/// A scene.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its file, seen from the folder, with `/` between names.
    pub name: String,
    pub seconds: f64,
    pub verdict: Verdict,
    /// What was written to show the difference.
    pub files: Vec<String>,
    /// The pictures, where they differ.
    pub shown: Option<Shown>,
}

/// Pictures that differ.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The one that is kept.
    pub expected: Film,
    pub actual: Film,
    /// The relMSE of each pixel as a colour; of pictures of one size.
    pub heat: Option<Film>,
}

/// What became of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The kept picture, to the bit.
    Same,
    /// Another, within the relMSE that is allowed.
    Close { rel_mse: f64 },
    /// It is kept from now on; there was another before, or none.
    Kept { instead: bool },
    /// Another picture, and how it differs.
    Differs(String),
    /// There is no picture to compare, and why.
    Failed(String),
}

impl Verdict {
    /// What is wrong, if anything.
    pub fn wrong(&self) -> Option<&str> {
        match self {
            Self::Same | Self::Close { .. } | Self::Kept { .. } => None,
            Self::Differs(why) | Self::Failed(why) => Some(why),
        }
    }
}

impl Suite {
    /// How many went wrong.
    pub fn wrong(&self) -> usize {
        let wrong = self.cases.iter().filter(|c| c.verdict.wrong().is_some());
        wrong.count()
    }
}
