//! The numbers of a PLY file's body, in text or in binary.

use super::declared::Scalar;
use crate::scene::mesh::text::{Tokens, float, integer};

/// A sequence of numbers.
pub(super) trait Source {
    /// The next number. A float in text is rounded like a binary one.
    fn real(&mut self, of: Scalar) -> Result<f64, Fault>;

    /// The next number, which must be an integer.
    fn whole(&mut self, of: Scalar) -> Result<i64, Fault>;

    /// Skips the next number.
    fn skip(&mut self, of: Scalar) -> Result<(), Fault>;

    /// The line of the last number, from 1; 0 in binary.
    fn line(&self) -> usize;

    fn bytes_left(&self) -> usize;
}

/// The reason for a missing number.
pub(super) enum Fault {
    End,
    /// A line of text that cannot be parsed.
    Line(usize),
}

/// A stream of tokens, regardless of line ends.
pub(super) struct Text<'a>(pub(super) Tokens<'a>);

impl Text<'_> {
    fn next<T>(&mut self, parse: impl FnOnce(&[u8]) -> Option<T>) -> Result<T, Fault> {
        let token = self.0.next().ok_or(Fault::End)?;
        parse(token).ok_or(Fault::Line(self.0.line()))
    }
}

impl Source for Text<'_> {
    fn real(&mut self, of: Scalar) -> Result<f64, Fault> {
        self.next(|token| match of {
            Scalar::F32 => float::<f32>(token).map(f64::from),
            _ => float(token),
        })
    }

    fn whole(&mut self, _: Scalar) -> Result<i64, Fault> {
        self.next(integer)
    }

    fn skip(&mut self, _: Scalar) -> Result<(), Fault> {
        self.next(|_| Some(()))
    }

    fn line(&self) -> usize {
        self.0.line()
    }

    fn bytes_left(&self) -> usize {
        self.0.bytes_left()
    }
}

/// Binary numbers.
pub(super) struct Binary<'a> {
    pub(super) rest: &'a [u8],
    pub(super) big_endian: bool,
}

impl Binary<'_> {
    /// The next number, little endian.
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], Fault> {
        let (bytes, rest) = self.rest.split_first_chunk::<N>().ok_or(Fault::End)?;
        self.rest = rest;
        let mut bytes = *bytes;
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

impl Source for Binary<'_> {
    fn real(&mut self, of: Scalar) -> Result<f64, Fault> {
        match of {
            Scalar::F32 => Ok(f32::from_le_bytes(self.bytes()?).into()),
            Scalar::F64 => Ok(f64::from_le_bytes(self.bytes()?)),
            _ => Ok(self.whole(of)? as f64),
        }
    }

    fn whole(&mut self, of: Scalar) -> Result<i64, Fault> {
        Ok(match of {
            Scalar::I8 => i8::from_le_bytes(self.bytes()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.bytes()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.bytes()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.bytes()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.bytes()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.bytes()?).into(),
            // Lists of these types cannot be declared.
            Scalar::F32 | Scalar::F64 => self.real(of)? as i64,
        })
    }

    fn skip(&mut self, of: Scalar) -> Result<(), Fault> {
        self.rest = self.rest.get(of.size()..).ok_or(Fault::End)?;
        Ok(())
    }

    fn line(&self) -> usize {
        0
    }

    fn bytes_left(&self) -> usize {
        self.rest.len()
    }
}
