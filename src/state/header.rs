//! The origin of a part, and the layout of its sums in the file.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::StateError;
use crate::film::Keeps;
use crate::part::{Layout, Tally};
use crate::report::Record;

/// The origin of a part. Parts can be joined if everything is equal except times, device and samples of the record.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Header {
    /// A digest of the scene's text and of the bytes of all its meshes.
    pub digest: String,
    /// The rounding of its device: parts that agree in it join to the bits of one rendering.
    pub rounding: String,
    /// The rendering, as in `--json`.
    pub record: Record,
}

/// Everything in the file before the sums.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Preamble {
    /// The first index, and one past the last.
    pub samples: [u32; 2],
    /// Width and height of the picture, or of its crop.
    pub area: [u32; 2],
    /// `f32` or `f64`.
    pub scalar: String,
    /// Whether moments are stored with the sums.
    pub moments: bool,
    /// Whether quarters are stored with the sums.
    #[serde(default, skip_serializing_if = "is_false")]
    pub quarters: bool,
    pub tally: Tally,
    #[serde(flatten)]
    pub header: Header,
}

fn is_false(value: &bool) -> bool {
    !value
}

impl Preamble {
    pub fn range(&self) -> Range<u32> {
        self.samples[0]..self.samples[1]
    }

    pub fn layout(&self) -> Layout {
        Layout::new(self.range())
    }

    /// The data stored with each sum.
    pub fn keeps(&self) -> Keeps {
        match (self.moments, self.quarters) {
            (true, _) => Keeps::Moments,
            (false, true) => Keeps::Quarters,
            (false, false) => Keeps::Nothing,
        }
    }

    pub fn pixels(&self) -> u64 {
        u64::from(self.area[0]) * u64::from(self.area[1])
    }

    /// Bytes of the sums with scalars of this size; `None` beyond 2⁶⁴.
    pub fn bytes(&self, scalar: u64) -> Option<u64> {
        let a_pixel = self.layout().scalars(self.keeps()) * scalar;
        a_pixel.checked_mul(self.pixels())
    }

    /// Checks that its values are possible and agree with the record.
    pub fn check(&self) -> Result<(), StateError> {
        let wrong = |what: &str| Err(StateError::Header(what.to_owned()));
        let [begin, end] = self.samples;
        let job = &self.header.record.job;
        let area = match job.crop {
            None => Some(job.size),
            Some([x0, y0, x1, y1]) => {
                let within = x1 <= job.size[0] && y1 <= job.size[1];
                let size = x1.checked_sub(x0).zip(y1.checked_sub(y0));
                size.filter(|_| within)
                    .map(|(width, height)| [width, height])
            }
        };
        match () {
            () if begin >= end => wrong("it has no samples"),
            () if self.pixels() == 0 || self.pixels() > u64::from(u32::MAX) => {
                wrong("it has no pixels, or too many")
            }
            () if self.moments && self.quarters => wrong("it has moments and quarters"),
            () if area != Some(self.area) => wrong("its area does not match its picture"),
            () if job.spp != end - begin => {
                wrong("its number of samples does not match its record")
            }
            () => Ok(()),
        }
    }
}
