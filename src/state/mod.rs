//! Parts of pictures in files: what `--samples`, checkpoints and `vkpt merge` write, and read back whole or not at all.
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

/// What a file of this format ends in.
pub const ENDING: &str = "vkpt";

/// The first bytes of every file.
const MAGIC: [u8; 8] = *b"vkptpart";
/// Of the format; goes up with every change of it.
const VERSION: u32 = 1;
/// Bytes of the longest header that is read.
const LONGEST_HEADER: u32 = 1 << 20;
/// Bytes of the checksum.
const CHECKSUM: usize = blake3::OUT_LEN;

/// A part, and all that it was made from.
#[derive(Clone, Debug)]
pub struct Kept {
    pub header: Header,
    pub part: AnyPart,
}
