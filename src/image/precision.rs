//! Bounds the difference between stored and original values.

use super::srgb;

/// The rounding of a picture's values in its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// EXR's `FLOAT`: f32.
    Single,
    /// EXR's `FLOAT` compressed by PXR24, which keeps 16 of 24 significant bits.
    Pxr24,
    /// EXR's `HALF`: f16.
    Half,
    /// HDR: bytes with a common exponent.
    Rgbe,
    /// PNG: sRGB codes from 0 to 2^`bits` − 1.
    Srgb { bits: u8 },
    /// EXR's B44 and DWA, whose error depends on neighbouring pixels.
    Lossy,
}

impl Precision {
    /// For a pixel as read: the largest rounding error of each channel, in linear radiance; `None` if there is no
    /// bound. The bound applies within the format's range: clamping to the limits of a PNG or an HDR is not rounding.
    pub fn rounding(self, rgb: [f32; 3]) -> Option<[f64; 3]> {
        // Half a unit in the last place: |x|·2^-(significant bits), or half the smallest subnormal.
        let float = |significant: i32, smallest: i32| {
            rgb.map(|x| {
                (f64::from(x).abs() * power_of_2(-significant)).max(power_of_2(smallest - 1))
            })
        };
        match self {
            Self::Single => Some(float(24, -149)),
            Self::Pxr24 => Some(float(16, -141)),
            Self::Half => Some(float(11, -24)),
            Self::Rgbe => Some([rgbe(rgb); 3]),
            Self::Srgb { bits } => Some(rgb.map(|x| code(x, bits))),
            Self::Lossy => None,
        }
    }

    /// The precision of a picture with channels of both.
    pub(super) fn coarser(self, other: Self) -> Self {
        let rank = |precision| match precision {
            Self::Single => 0,
            Self::Pxr24 => 1,
            Self::Half => 2,
            Self::Rgbe => 3,
            Self::Srgb { .. } => 4,
            Self::Lossy => 5,
        };
        if rank(other) > rank(self) {
            other
        } else {
            self
        }
    }
}

/// A whole step, because most writers truncate: 2⁻⁷ of the largest channel, whose m is at least 128. Values below
/// [`super::rgbe::BLACK`] may have become 0.
fn rgbe(rgb: [f32; 3]) -> f64 {
    let largest = rgb.into_iter().fold(0.0, f32::max);
    (f64::from(largest) / 128.0).max(f64::from(super::rgbe::BLACK))
}

/// Half a code upwards: the inverse transfer is convex, so the distance to half a code below is no larger. The film's
/// own f32 rounding is added.
fn code(x: f32, bits: u8) -> f64 {
    let x = f64::from(x);
    let half = 0.5 / (power_of_2(i32::from(bits)) - 1.0);
    srgb::linear(srgb::transfer(x) + half) - x + x * power_of_2(-24)
}

fn power_of_2(exponent: i32) -> f64 {
    f64::from(exponent).exp2()
}
