//! A part with either scalar.

use std::ops::Range;

use super::{Half, Halves, Misfit, Part, Tally};
use crate::film::{Film, Keeps};
use crate::reference::math::Real;

/// A part of a device or `cpu-f32`, or of `cpu-f64`.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyPart {
    F32(Part<f32>),
    F64(Part<f64>),
}

/// A scalar of parts.
pub trait Scalar: Real {
    /// Wraps a part.
    fn any(part: Part<Self>) -> AnyPart;
    /// Unwraps a part; `None` if it has the other scalar.
    fn of(part: AnyPart) -> Option<Part<Self>>;
}

impl Scalar for f32 {
    fn any(part: Part<Self>) -> AnyPart {
        AnyPart::F32(part)
    }
    fn of(part: AnyPart) -> Option<Part<Self>> {
        match part {
            AnyPart::F32(part) => Some(part),
            AnyPart::F64(_) => None,
        }
    }
}

impl Scalar for f64 {
    fn any(part: Part<Self>) -> AnyPart {
        AnyPart::F64(part)
    }
    fn of(part: AnyPart) -> Option<Part<Self>> {
        match part {
            AnyPart::F64(part) => Some(part),
            AnyPart::F32(_) => None,
        }
    }
}

/// Applies an expression to a part of either scalar.
macro_rules! either {
    ($self:expr, $part:ident => $value:expr) => {
        match $self {
            AnyPart::F32($part) => $value,
            AnyPart::F64($part) => $value,
        }
    };
}

impl AnyPart {
    /// See [`Part::size`].
    pub fn size(&self) -> [u32; 2] {
        either!(self, p => p.size())
    }

    /// See [`Part::range`].
    pub fn range(&self) -> Range<u32> {
        either!(self, p => p.range())
    }

    /// See [`Part::samples`].
    pub fn samples(&self) -> u32 {
        either!(self, p => p.samples())
    }

    /// See [`Part::keeps`].
    pub fn keeps(&self) -> Keeps {
        either!(self, p => p.keeps())
    }

    /// The counts of its samples.
    pub fn tally(&self) -> Tally {
        either!(self, p => p.tally)
    }

    /// See [`Part::picture`].
    pub fn picture(&self) -> Film {
        either!(self, p => p.picture())
    }

    /// See [`Part::halves`].
    pub fn halves(&self) -> Halves {
        either!(self, p => p.halves())
    }

    /// See [`Part::standard_errors`].
    pub fn standard_errors(&self) -> Film {
        either!(self, p => p.standard_errors())
    }

    /// See [`Part::freedom`].
    pub fn freedom(&self) -> f64 {
        either!(self, p => p.freedom())
    }

    /// See [`Part::quartered`].
    pub fn quartered(&self) -> Option<[Half; 2]> {
        either!(self, p => p.quartered())
    }

    /// See [`Part::append`]; `look` receives the number of samples, and a function that computes their halves.
    pub fn append(
        &mut self,
        next: Self,
        look: &mut dyn FnMut(u32, &dyn Fn() -> Halves),
    ) -> Result<(), Misfit> {
        match (self, next) {
            (Self::F32(part), Self::F32(next)) => {
                part.append(next, &mut |p| look(p.samples(), &|| p.halves()))
            }
            (Self::F64(part), Self::F64(next)) => {
                part.append(next, &mut |p| look(p.samples(), &|| p.halves()))
            }
            _ => Err(Misfit::Scalar),
        }
    }
}
