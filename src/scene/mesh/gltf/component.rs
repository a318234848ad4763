//! The component types of accessors (glTF 2.0, section 3.6.2.2, *Accessor Data Types*).

/// The type of a component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    /// The type of a `componentType`. Errors are messages.
    pub(super) fn of(code: u64) -> Result<Self, String> {
        match code {
            5120 => Ok(Self::I8),
            5121 => Ok(Self::U8),
            5122 => Ok(Self::I16),
            5123 => Ok(Self::U16),
            5125 => Ok(Self::U32),
            5126 => Ok(Self::F32),
            _ => Err(format!("its component type {code} is unknown")),
        }
    }

    /// In bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// May be the type of indices of vertices or joints.
    pub(super) fn is_index(self) -> bool {
        matches!(self, Self::U8 | Self::U16 | Self::U32)
    }

    /// The largest unsigned number with this many bits.
    pub(super) fn all_ones(self) -> u32 {
        u32::MAX >> (32 - 8 * self.size())
    }

    /// The unsigned number at the start of `bytes`, little endian.
    pub(super) fn whole(self, bytes: &[u8]) -> u32 {
        let bytes = &bytes[..self.size()];
        bytes
            .iter()
            .rev()
            .fold(0, |n, byte| n << 8 | u32::from(*byte))
    }

    /// The number at the start of `bytes`; a normalised one is in [0, 1] or [−1, 1] (glTF 2.0, section 3.11,
    /// *Animations*, table of normalised integers).
    pub(super) fn number(self, normalized: bool, bytes: &[u8]) -> f64 {
        let bits = self.whole(bytes);
        let (value, most) = match self {
            Self::F32 => return f64::from(f32::from_bits(bits)),
            Self::I8 => (f64::from(bits as u8 as i8), f64::from(i8::MAX)),
            Self::U8 => (f64::from(bits), f64::from(u8::MAX)),
            Self::I16 => (f64::from(bits as u16 as i16), f64::from(i16::MAX)),
            Self::U16 => (f64::from(bits), f64::from(u16::MAX)),
            Self::U32 => (f64::from(bits), f64::from(u32::MAX)),
        };
        match normalized {
            true => (value / most).max(-1.0),
            false => value,
        }
    }
}
