//! Reading a part.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use super::header::{Header, Preamble};
use super::scalars::{Bytes, Packed};
use super::{CHECKSUM, Kept, LONGEST_HEADER, MAGIC, StateError, VERSION};
use crate::film::Keeps;
use crate::part::{AnyPart, Beside, Part, PixelSums, Sums};
use crate::reference::film::{FilmMoments, FilmQuarters};
use crate::reference::math::Vec3;

/// Records read at once.
const CHUNK: usize = 1 << 14;
/// Bytes before the header's text.
const BEFORE: u64 = 16;

/// Reads a complete file.
///
/// # Errors
/// The file is not a part, has another version, is cut short or damaged: none of it is used.
pub fn read(path: &Path) -> Result<Kept, StateError> {
    let (file, length) = open(path)?;
    whole(file, length)
}

/// The origin of a file; the first index of its samples and one past the last; the data stored with its sums. The rest
/// is not checked, except for its length.
pub fn read_header(path: &Path) -> Result<(Header, [u32; 2], Keeps), StateError> {
    let (file, length) = open(path)?;
    let preamble = Reader::new(file).preamble(length)?;
    let keeps = preamble.keeps();
    Ok((preamble.header, preamble.samples, keeps))
}

/// Like [`read`], from bytes.
pub fn parse(bytes: &[u8]) -> Result<Kept, StateError> {
    whole(bytes, bytes.len() as u64)
}

fn open(path: &Path) -> Result<(File, u64), StateError> {
    // Opening a pipe could block forever.
    let there = path.metadata()?;
    match there.is_file() {
        true => Ok((File::open(path)?, there.len())),
        false => Err(io::Error::other("it is not a regular file").into()),
    }
}

fn whole(from: impl Read, length: u64) -> Result<Kept, StateError> {
    let mut reader = Reader::new(from);
    let preamble = reader.preamble(length)?;
    let part = match &*preamble.scalar {
        f32::NAME => AnyPart::F32(reader.part(&preamble)?),
        _ => AnyPart::F64(reader.part(&preamble)?),
    };
    let own = reader.hasher.finalize();
    let mut checksum = [0; CHECKSUM];
    reader.from.read_exact(&mut checksum)?;
    if own != checksum {
        return Err(StateError::Checksum);
    }
    let header = preamble.header;
    Ok(Kept { header, part })
}

/// Reads and hashes everything.
struct Reader<R> {
    from: R,
    hasher: blake3::Hasher,
    chunk: Vec<u8>,
}

impl<R: Read> Reader<R> {
    fn new(from: R) -> Self {
        Self {
            from,
            hasher: blake3::Hasher::new(),
            chunk: Vec::new(),
        }
    }

    /// The next `count` bytes.
    fn bytes(&mut self, count: usize) -> io::Result<&[u8]> {
        self.chunk.resize(count, 0);
        self.from.read_exact(&mut self.chunk)?;
        self.hasher.update(&self.chunk);
        Ok(&self.chunk)
    }

    fn number(&mut self) -> io::Result<u32> {
        let bytes = self.bytes(4)?;
        Ok(bytes.iter().rev().fold(0, |n, &b| n << 8 | u32::from(b)))
    }

    /// Everything before the sums; checks that `length` is the declared length of the file.
    fn preamble(&mut self, length: u64) -> Result<Preamble, StateError> {
        match self.bytes(MAGIC.len()) {
            Ok(magic) if magic == MAGIC => {}
            Err(error) if error.kind() != ErrorKind::UnexpectedEof => return Err(error.into()),
            _ => return Err(StateError::Foreign),
        }
        let version = self.number()?;
        if version != VERSION {
            return Err(StateError::Version(version, VERSION));
        }
        let header = self.number()?;
        if header > LONGEST_HEADER {
            return Err(StateError::Header("it is too long".to_owned()));
        }
        let text = self.bytes(header as usize)?;
        let preamble: Preamble = serde_json::from_slice(text).map_err(wrong)?;
        preamble.check()?;
        let scalar = match &*preamble.scalar {
            f32::NAME => f32::BYTES,
            f64::NAME => f64::BYTES,
            _ => return Err(StateError::Header("its scalar is unknown".to_owned())),
        };
        let around = BEFORE + u64::from(header) + CHECKSUM as u64;
        let sums = preamble.bytes(scalar as u64);
        let wanted = sums.and_then(|sums| sums.checked_add(around));
        match wanted {
            Some(wanted) if wanted == length => Ok(preamble),
            wanted => Err(StateError::Length {
                has: length,
                wanted: wanted.unwrap_or(u64::MAX),
            }),
        }
    }

    /// The sums; the preamble gives their length.
    fn part<F: Bytes>(&mut self, preamble: &Preamble) -> io::Result<Part<F>> {
        let layout = preamble.layout();
        let pixels = preamble.pixels() as usize;
        let mut head = Vec::new();
        for _ in 0..layout.head {
            head.push(self.array::<F, Vec3<F>>(pixels)?);
        }
        let mut sums = Vec::new();
        for samples in layout.sums() {
            sums.push(Sums {
                samples,
                pixels: self.array::<F, PixelSums<F>>(pixels)?,
                beside: match preamble.keeps() {
                    Keeps::Nothing => Beside::Nothing,
                    Keeps::Moments => Beside::Moments(self.array::<F, FilmMoments<F>>(pixels)?),
                    Keeps::Quarters => Beside::Quarters(self.array::<F, FilmQuarters<F>>(pixels)?),
                },
            });
        }
        let [begin, end] = preamble.samples;
        let mut empty = Part::new(preamble.area, preamble.keeps(), begin);
        empty.tally = preamble.tally;
        Ok(Part::assembled(empty, end, head, sums))
    }

    fn array<F: Bytes, T: Packed<F>>(&mut self, count: usize) -> io::Result<Vec<T>> {
        let size = 3 * F::BYTES * T::VECTORS;
        let mut all = Vec::with_capacity(count);
        while all.len() < count {
            let bytes = self.bytes(size * CHUNK.min(count - all.len()))?;
            all.extend(bytes.chunks_exact(size).map(T::unpack));
        }
        Ok(all)
    }
}

/// The message for a header that is no JSON or has other fields, without control characters for a terminal.
fn wrong(error: serde_json::Error) -> StateError {
    StateError::Header(error.to_string().escape_debug().to_string())
}
