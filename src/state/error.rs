//! Why a file is not accepted as a part.

use std::io;

#[derive(Debug, thiserror::Error)]
pub enum StateError {
    #[error("{0}")]
    Io(#[from] io::Error),
    #[error("it is not a part of a rendering: it does not start like a .vkpt file")]
    Foreign,
    #[error(
        "its format is version {0}, but this vkpt reads version {1}: use the vkpt that wrote it"
    )]
    Version(u32, u32),
    #[error("it has {has} bytes instead of {wanted}: it is truncated, or has extra bytes")]
    Length { has: u64, wanted: u64 },
    #[error("its header is wrong: {0}")]
    Header(String),
    #[error("it is damaged: its checksum does not match its bytes")]
    Checksum,
}
