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
    #[error("is not a picture in a supported format: EXR, HDR or PNG")]
    Unknown,
    /// The message of the format's crate.
    #[error("is damaged: {0}")]
    Broken(String),
    #[error("not supported: {0}")]
    Unsupported(String),
    #[error("has no pixels")]
    NoPixels,
    #[error("{width}×{height} pixels are too many: the limit is 2²⁸")]
    TooLarge { width: u64, height: u64 },
    #[error("is damaged: {bytes} bytes cannot contain {width}×{height} pixels")]
    Lying { width: u64, height: u64, bytes: u64 },
    #[error("is not an EXR, so it has no layers")]
    NoLayers,
    #[error("has no layer {layer}; its channels are {}", channels.join(", "))]
    NoLayer {
        layer: String,
        channels: Vec<String>,
    },
    #[error("has no channels R, G and B; its channels are {}", channels.join(", "))]
    Missing { channels: Vec<String> },
    #[error("has R, G and B in several layers, which is ambiguous: {}", layers.join(", "))]
    Ambiguous { layers: Vec<String> },
    #[error("has integers (UINT) in channel {channel}, but radiance needs floats")]
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
