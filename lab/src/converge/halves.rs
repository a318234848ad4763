//! A reference rendered by vkpt itself: the scene twice, with independent random numbers.

use std::sync::atomic::AtomicBool;

use super::{ConvergeError, Part, Progress};
use vkpt::film::Film;
use vkpt::render::{Engine, Job, Replicates};

/// The seeds of the halves. No replicate may use them.
pub const HALVES: [u32; 2] = [u32::MAX - 1, u32::MAX];

/// Two pictures of the same scene with the same number of samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Halves {
    pub films: [Film; 2],
    /// Samples per pixel of each.
    pub spp: u32,
    /// Time of both.
    pub seconds: f64,
}

impl Halves {
    /// For [`Halves::from_bytes`]: samples, seconds, width, height, then the pixels of both, least significant bytes first.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Film { width, height, .. } = self.films[0];
        let mut bytes = self.spp.to_le_bytes().to_vec();
        bytes.extend(self.seconds.to_le_bytes());
        bytes.extend([width, height].map(u32::to_le_bytes).as_flattened());
        let pixels = self.films.iter().flat_map(|film| film.rgb.as_flattened());
        bytes.extend(pixels.flat_map(|value| value.to_le_bytes()));
        bytes
    }

    /// `None` for any other bytes.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (spp, rest) = bytes.split_first_chunk()?;
        let (seconds, rest) = rest.split_first_chunk()?;
        let (width, rest) = rest.split_first_chunk()?;
        let (height, rest) = rest.split_first_chunk()?;
        let [width, height] = [width, height].map(|side| u32::from_le_bytes(*side));
        let (words, []) = rest.as_chunks() else {
            return None;
        };
        let values: Vec<f32> = words.iter().map(|word| f32::from_le_bytes(*word)).collect();
        let (pixels, []) = values.as_chunks() else {
            return None;
        };
        let count = usize::try_from(u64::from(width) * u64::from(height)).ok()?;
        if Some(pixels.len()) != count.checked_mul(2) {
            return None;
        }
        let film = |rgb: &[[f32; 3]]| Film {
            width,
            height,
            rgb: rgb.to_vec(),
        };
        let (a, b) = pixels.split_at(count);
        Some(Self {
            films: [film(a), film(b)],
            spp: u32::from_le_bytes(*spp),
            seconds: f64::from_le_bytes(*seconds),
        })
    }
}

/// Renders both halves in alternation until they took `seconds` together, with at most `spp` samples each; `None` if
/// `stop` came first. The job's seed and samples are ignored.
///
/// # Errors
/// Those of a rendering.
pub fn halves(
    job: &Job,
    engine: &Engine,
    (seconds, most): (f64, u32),
    stop: &AtomicBool,
    progress: &mut dyn FnMut(Progress),
) -> Result<Option<Halves>, ConvergeError> {
    let mut replicates = Replicates::new(job, engine, &HALVES)?;
    let (mut spent, mut spp) = (0.0, 1);
    loop {
        for i in 0..HALVES.len() {
            spent += replicates.advance(i, spp, stop)?.wall_s;
            if replicates.done(i) < spp {
                return Ok(None);
            }
        }
        progress(Progress {
            part: Part::Reference,
            spp,
            spent_s: spent,
            seconds,
        });
        // The samples that fit into the remaining time at the pace so far; at most twice as many, to measure the pace better.
        let fits = f64::from(spp) * (seconds / spent).min(2.0);
        let next = (fits as u32).min(most);
        if next <= spp {
            return Ok(Some(Halves {
                films: [0, 1].map(|i| replicates.picture(i)),
                spp,
                seconds: spent,
            }));
        }
        spp = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_read_back_whole_or_not_at_all() {
        let film = |first: f32| Film {
            width: 2,
            height: 1,
            rgb: vec![[first, 0.25, -1.5], [0.0, 3e9, f32::MIN_POSITIVE]],
        };
        let halves = Halves {
            films: [film(1.0), film(2.0)],
            spp: 12,
            seconds: 0.75,
        };
        let bytes = halves.to_bytes();
        assert_eq!(Halves::from_bytes(&bytes), Some(halves));
        for length in 0..bytes.len() {
            assert_eq!(Halves::from_bytes(&bytes[..length]), None, "{length}");
        }
        assert_eq!(Halves::from_bytes(&[&bytes[..], &[0; 12]].concat()), None);
    }
}
