//! Parts of pictures in files: `--samples`, checkpoints and `vkpt merge` write them; a file is read whole or refused.
//! docs/state-format.md has the format.

mod differs;
mod error;
mod header;
mod read;
mod scalars;
mod write;

use crate::part::AnyPart;
pub use differs::differs;
pub use error::StateError;
pub use header::Header;
pub use read::{parse, read, read_header};
pub use write::write;

/// The extension of files of this format.
pub const ENDING: &str = "vkpt";

/// The first bytes of every file.
const MAGIC: [u8; 8] = *b"vkptpart";
/// Version of the format; increases with every change.
const VERSION: u32 = 1;
/// Maximum length in bytes of a header.
const LONGEST_HEADER: u32 = 1 << 20;
/// Bytes of the checksum.
const CHECKSUM: usize = blake3::OUT_LEN;

/// A part and its origin.
#[derive(Clone, Debug)]
pub struct Kept {
    pub header: Header,
    pub part: AnyPart,
}
