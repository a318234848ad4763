//! Writing a part.

use std::io::{self, Write};

use super::header::{Header, Preamble};
use super::scalars::{self, Bytes, Packed, Sink};
use super::{CHECKSUM, LONGEST_HEADER, MAGIC, VERSION};
use crate::film::Keeps;
use crate::part::AnyPart;

/// Pixels written at once.
const CHUNK: usize = 1 << 14;

/// Writes a part and its origin.
///
/// # Errors
/// Errors of `out`, and headers too long to be read back, such as a thousand meshes with long names.
pub fn write(out: &mut dyn Write, header: &Header, part: &AnyPart) -> io::Result<()> {
    let scalar = match part {
        AnyPart::F32(_) => f32::NAME,
        AnyPart::F64(_) => f64::NAME,
    };
    let preamble = Preamble {
        samples: [part.range().start, part.range().end],
        area: part.size(),
        scalar: scalar.to_owned(),
        moments: part.keeps() == Keeps::Moments,
        quarters: part.keeps() == Keeps::Quarters,
        tally: part.tally(),
        header: header.clone(),
    };
    let text = serde_json::to_vec(&preamble)?;
    let length = u32::try_from(text.len()).unwrap_or(u32::MAX);
    if length > LONGEST_HEADER {
        return Err(io::Error::other("its header would be too long"));
    }
    let mut sealed = Sealed {
        out,
        hasher: blake3::Hasher::new(),
        chunk: Vec::new(),
    };
    sealed.bytes(&MAGIC)?;
    sealed.bytes(&VERSION.to_le_bytes())?;
    sealed.bytes(&length.to_le_bytes())?;
    sealed.bytes(&text)?;
    scalars::arrays(part, &mut sealed)?;
    let checksum: [u8; CHECKSUM] = sealed.hasher.finalize().into();
    sealed.out.write_all(&checksum)
}

/// Writes and hashes everything.
struct Sealed<'a> {
    out: &'a mut dyn Write,
    hasher: blake3::Hasher,
    chunk: Vec<u8>,
}

impl Sealed<'_> {
    fn bytes(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.hasher.update(bytes);
        self.out.write_all(bytes)
    }
}

impl Sink for Sealed<'_> {
    type Error = io::Error;

    fn array<F: Bytes, T: Packed<F> + Sync>(&mut self, array: &[T]) -> io::Result<()> {
        for items in array.chunks(CHUNK) {
            self.chunk.clear();
            items.iter().for_each(|item| item.pack(&mut self.chunk));
            self.hasher.update(&self.chunk);
            self.out.write_all(&self.chunk)?;
        }
        Ok(())
    }
}
