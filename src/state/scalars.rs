//! Scalars as little-endian bytes.

use crate::part::{AnyPart, Beside, Part, PixelSums, Scalar, Sums};
use crate::reference::film::{FilmMoments, FilmQuarters, PixelSum};
use crate::reference::math::{Vec3, vec3};

/// A scalar in files.
pub trait Bytes: Scalar {
    const NAME: &'static str;
    const BYTES: usize;
    fn put(self, out: &mut Vec<u8>);
    /// Reads a scalar from [`BYTES`](Self::BYTES) bytes.
    fn get(bytes: &[u8]) -> Self;
}

macro_rules! bytes {
    ($t:ty) => {
        impl Bytes for $t {
            const NAME: &'static str = stringify!($t);
            const BYTES: usize = size_of::<$t>();
            fn put(self, out: &mut Vec<u8>) {
                out.extend_from_slice(&self.to_le_bytes());
            }
            fn get(bytes: &[u8]) -> Self {
                let mut own = [0; size_of::<$t>()];
                own.copy_from_slice(bytes);
                <$t>::from_le_bytes(own)
            }
        }
    };
}

bytes!(f32);
bytes!(f64);

/// A record of several vectors of three scalars.
pub trait Packed<F>: Sized {
    /// Vectors per record.
    const VECTORS: usize;
    fn pack(&self, out: &mut Vec<u8>);
    /// Reads a record from the bytes of all its vectors.
    fn unpack(bytes: &[u8]) -> Self;
}

impl<F: Bytes> Packed<F> for Vec3<F> {
    const VECTORS: usize = 1;
    fn pack(&self, out: &mut Vec<u8>) {
        [self.x, self.y, self.z]
            .into_iter()
            .for_each(|x| x.put(out));
    }
    fn unpack(bytes: &[u8]) -> Self {
        let scalar = |i: usize| F::get(&bytes[i * F::BYTES..(i + 1) * F::BYTES]);
        vec3(scalar(0), scalar(1), scalar(2))
    }
}

/// Vector `i` of a record's bytes.
fn vector<F: Bytes>(bytes: &[u8], i: usize) -> Vec3<F> {
    Vec3::unpack(&bytes[i * 3 * F::BYTES..(i + 1) * 3 * F::BYTES])
}

fn sum<F: Bytes>(bytes: &[u8], i: usize) -> PixelSum<F> {
    PixelSum {
        sum: vector(bytes, i),
        comp: vector(bytes, i + 1),
    }
}

impl<F: Bytes> Packed<F> for PixelSums<F> {
    const VECTORS: usize = 3;
    fn pack(&self, out: &mut Vec<u8>) {
        let all = [self.sum.sum, self.sum.comp, self.contrast];
        all.iter().for_each(|v| v.pack(out));
    }
    fn unpack(bytes: &[u8]) -> Self {
        Self {
            sum: sum(bytes, 0),
            contrast: vector(bytes, 2),
        }
    }
}

impl<F: Bytes> Packed<F> for FilmMoments<F> {
    const VECTORS: usize = 4;
    fn pack(&self, out: &mut Vec<u8>) {
        let all = [self.mean.sum, self.mean.comp, self.m2.sum, self.m2.comp];
        all.iter().for_each(|v| v.pack(out));
    }
    fn unpack(bytes: &[u8]) -> Self {
        Self {
            mean: sum(bytes, 0),
            m2: sum(bytes, 2),
        }
    }
}

impl<F: Bytes> Packed<F> for FilmQuarters<F> {
    const VECTORS: usize = 2;
    fn pack(&self, out: &mut Vec<u8>) {
        [self.even, self.odd].iter().for_each(|v| v.pack(out));
    }
    fn unpack(bytes: &[u8]) -> Self {
        Self {
            even: vector(bytes, 0),
            odd: vector(bytes, 1),
        }
    }
}

/// Receives the arrays of a part one after the other.
pub trait Sink {
    type Error;
    fn array<F: Bytes, T: Packed<F> + Sync>(&mut self, array: &[T]) -> Result<(), Self::Error>;
}

/// Passes the arrays of a part to `sink`, in the order of the file.
pub fn arrays<S: Sink>(part: &AnyPart, sink: &mut S) -> Result<(), S::Error> {
    match part {
        AnyPart::F32(part) => arrays_of(part, sink),
        AnyPart::F64(part) => arrays_of(part, sink),
    }
}

fn arrays_of<F: Bytes, S: Sink>(part: &Part<F>, sink: &mut S) -> Result<(), S::Error> {
    for values in part.head() {
        sink.array::<F, _>(values)?;
    }
    for Sums { pixels, beside, .. } in part.sums() {
        sink.array::<F, _>(pixels)?;
        match beside {
            Beside::Nothing => {}
            Beside::Moments(moments) => sink.array::<F, _>(moments)?,
            Beside::Quarters(quarters) => sink.array::<F, _>(quarters)?,
        }
    }
    Ok(())
}
