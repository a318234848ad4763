//! Why a file is refused as a part.

use std::io;

#[derive(Debug, thiserror::Error)]
pub enum StateError {
    #[error("{0}")]
    Io(#[from] io::Error),
    #[error("it is no part of a rendering: it does not begin as vkpt's do")]
    Foreign,
    #[error(
        "its format is version {0}, and this vkpt reads version {1}: use the vkpt that wrote it"
    )]
    Version(u32, u32),
    #[error("it is cut short, or has more than it should: {has} bytes instead of {wanted}")]
    Length { has: u64, wanted: u64 },
    #[error("its header is wrong: {0}")]
    Header(String),
    #[error("it is damaged: its checksum is not that of its bytes")]
    Checksum,
}
