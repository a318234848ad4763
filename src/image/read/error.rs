//! Errors in reading a picture.

use std::io;
use std::path::PathBuf;

/// A file and its error.
#[derive(Debug, thiserror::Error)]
#[error("{}: {cause}", path.display())]
pub struct ReadError {
    pub path: PathBuf,
    pub cause: DecodeError,
}

/// A fault of a file, or a limit of vkpt.
#[derive(Debug, thiserror::Error)]
pub enum DecodeError {
    #[error("{0}")]
    Io(#[from] io::Error),
    #[error("is a folder")]
    Folder,
    #[error("is neither a file nor a folder")]
    NoFile,
    #[error("is empty")]
    Empty,
    #[error("is no picture that vkpt reads: EXR, HDR or PNG")]
    Unknown,
    /// The message of the format's crate.
    #[error("is broken: {0}")]
    Broken(String),
    #[error("vkpt can't read that: {0}")]
    Unsupported(String),
    #[error("holds no pixels")]
    NoPixels,
    #[error("{width}×{height} pixels are too many: vkpt reads up to 2²⁸")]
    TooLarge { width: u64, height: u64 },
    #[error("is broken: {bytes} bytes can't hold {width}×{height} pixels")]
    Lying { width: u64, height: u64, bytes: u64 },
    #[error("is no EXR, and has no layers")]
    NoLayers,
    #[error("has no layer {layer}; its channels are {}", channels.join(", "))]
    NoLayer {
        layer: String,
        channels: Vec<String>,
    },
    #[error("has no channels R, G and B; those that it has are {}", channels.join(", "))]
    Missing { channels: Vec<String> },
    #[error("has R, G and B in several layers, and vkpt can't know which is meant: {}", layers.join(", "))]
    Ambiguous { layers: Vec<String> },
    #[error("has whole numbers (UINT) for radiance in channel {channel}")]
    WholeNumbers { channel: String },
    #[error("its colours are not sRGB: {0}; convert them first")]
    Colours(String),
    #[error(
        "{count} of its values {} NaN or infinite; the first is {value} in pixel {x},{y} from the top left, channel {channel}",
        if *count == 1 { "is" } else { "are" }
    )]
    NotFinite {
        count: usize,
        value: f32,
        x: i64,
        y: i64,
        channel: char,
    },
}

impl DecodeError {
    /// The same without control characters that a terminal might interpret: names, and text quoted by a crate, come
    /// from the file.
    pub(super) fn printable(mut self) -> Self {
        let texts = match &mut self {
            Self::Broken(text) | Self::Unsupported(text) | Self::Colours(text) => {
                std::slice::from_mut(text)
            }
            Self::WholeNumbers { channel } => std::slice::from_mut(channel),
            Self::NoLayer {
                channels: names, ..
            }
            | Self::Missing { channels: names }
            | Self::Ambiguous { layers: names } => names,
            _ => &mut [],
        };
        for text in texts {
            *text = text.replace(char::is_control, "\u{fffd}");
        }
        self
    }
}
