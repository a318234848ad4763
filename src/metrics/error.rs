//! Errors of comparisons.

/// Why two pictures could not be compared. `picture` names the one at fault: `test picture`, `reference` …; rows count
/// from the top.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MetricsError {
    #[error(
        "the {picture} has {}×{} pixels, but the {other} {}×{}",
        size[0], size[1], other_size[0], other_size[1]
    )]
    Sizes {
        picture: &'static str,
        size: [u32; 2],
        other: &'static str,
        other_size: [u32; 2],
    },
    #[error("the {picture} has no pixels")]
    Empty { picture: &'static str },
    #[error("the {picture} is {width}×{height} pixels, but its film has {pixels}")]
    Film {
        picture: &'static str,
        width: u32,
        height: u32,
        pixels: usize,
    },
    #[error("invalid value {value} in the {picture} at column {x}, row {y}, channel {channel}")]
    Value {
        picture: &'static str,
        x: usize,
        y: usize,
        channel: char,
        value: f32,
    },
    #[error("FLIP needs 1 to 1000 pixels per degree, not {0}")]
    PixelsPerDegree(f64),
    #[error("a test's level must be between 0 and 1, not {0}")]
    Level(f64),
    #[error("the {picture} was compressed with losses that have no bound")]
    NoRounding { picture: &'static str },
}

impl MetricsError {
    /// The picture at fault, if one is.
    pub fn picture(&self) -> Option<&'static str> {
        match self {
            Self::Sizes { picture, .. }
            | Self::Empty { picture }
            | Self::Film { picture, .. }
            | Self::Value { picture, .. }
            | Self::NoRounding { picture } => Some(picture),
            Self::PixelsPerDegree(_) | Self::Level(_) => None,
        }
    }
}
