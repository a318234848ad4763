//! The closeness of two radiances of the same path.

pub use crate::layout::constants::decision::DARK;
use crate::sample::Address;

/// The maximum over the channels of |a − b| / max(|a|, |b|, [`DARK`]): in [0, 1] for radiances of one sign. `None` if
/// neither contributes light: no channel above `DARK`.
pub fn relative_difference(a: [f64; 3], b: [f64; 3]) -> Option<f64> {
    let size = |c: usize| a[c].abs().max(b[c].abs());
    let brightest = [0, 1, 2].map(size).into_iter().fold(0.0, f64::max);
    let difference = |c: usize| (a[c] - b[c]).abs() / size(c).max(DARK);
    (brightest > DARK).then(|| [0, 1, 2].map(difference).into_iter().fold(0.0, f64::max))
}

/// Bins per octave of the histogram: a quantile is off by at most half a bin, a factor of 2^(1/128), 0.55 %.
const BINS_PER_OCTAVE: f64 = 64.0;
/// The smallest difference distinguished from 0 is 2⁻⁶⁴.
const OCTAVES: f64 = 64.0;
const BINS: usize = (BINS_PER_OCTAVE * OCTAVES) as usize;

/// The largest difference and its sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    pub difference: f64,
    pub address: Address,
}

/// The distribution of relative differences.
#[derive(Clone, Debug)]
pub struct Closeness {
    /// Paths that contribute light.
    pub lit: u64,
    /// Differences of 0, or below 2⁻⁶⁴.
    none: u64,
    /// Bin i counts those in 2^(i/64 − 64) × [1, 2^(1/64)).
    bins: Vec<u64>,
    /// The first of the largest; exact. `None` if all are 0.
    pub worst: Option<Worst>,
}

impl Default for Closeness {
    fn default() -> Self {
        Self {
            lit: 0,
            none: 0,
            bins: vec![0; BINS],
            worst: None,
        }
    }
}

impl Closeness {
    pub fn add(&mut self, address: Address, a: [f64; 3], b: [f64; 3]) {
        let Some(difference) = relative_difference(a, b) else {
            return;
        };
        self.lit += 1;
        let bin = ((difference.log2() + OCTAVES) * BINS_PER_OCTAVE).floor();
        if bin < 0.0 {
            self.none += 1;
        } else {
            self.bins[(bin as usize).min(BINS - 1)] += 1;
        }
        if difference > self.worst.map_or(0.0, |w| w.difference) {
            self.worst = Some(Worst {
                difference,
                address,
            });
        }
    }

    /// The smallest difference that a share `q` of the paths does not exceed, to 0.55 %; `None` without paths.
    pub fn quantile(&self, q: f64) -> Option<f64> {
        let wanted = (q * self.lit as f64).ceil().max(1.0) as u64;
        let mut below = self.none;
        if self.lit == 0 || below >= wanted {
            return (self.lit > 0).then_some(0.0);
        }
        let within = |count: &u64| {
            below += count;
            below >= wanted
        };
        let bin = self.bins.iter().position(within)?;
        Some(f64::exp2((bin as f64 + 0.5) / BINS_PER_OCTAVE - OCTAVES))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: Address = Address {
        pixel: [3, 4],
        index: 5,
    };

    fn grey(x: f64) -> [f64; 3] {
        [x; 3]
    }

    #[test]
    fn the_worst_channel_counts_and_darkness_does_not() {
        assert_eq!(
            relative_difference([1.0, 0.0, 4.0], [1.0, 0.0, 3.0]),
            Some(0.25)
        );
        assert_eq!(relative_difference(grey(1.0), grey(0.0)), Some(1.0));
        assert_eq!(relative_difference(grey(0.0), grey(0.0)), None);
        assert_eq!(relative_difference(grey(1e-40), grey(1e-20)), None);
        // A channel that is black only in f32 says nothing about a path that is bright in another channel.
        let dim = relative_difference([1.0, 1e-35, 0.0], [1.0, 0.0, 0.0]);
        assert!(dim.is_some_and(|d| d < 1e-13), "{dim:?}");
    }

    /// Against the sorted differences themselves.
    #[test]
    fn quantiles_are_those_of_the_differences() {
        let mut closeness = Closeness::default();
        let mut differences = Vec::new();
        for i in 0..10_000u32 {
            let address = Address { index: i, ..HERE };
            // A tenth are equal, the others spread over nine octaves.
            let d = match i % 10 {
                0 => 0.0,
                _ => 1e-6 * f64::from(i.wrapping_mul(2_654_435_761) >> 8).sqrt(),
            };
            let d = d.min(1.0);
            differences.push(1.0 - (1.0 - d));
            closeness.add(address, grey(1.0 - d), grey(1.0));
        }
        let worst = closeness.worst.expect("differences");
        let most = differences.iter().copied().fold(0.0, f64::max);
        assert_eq!(worst.difference, most);
        assert_eq!(differences[worst.address.index as usize], most);
        differences.sort_by(f64::total_cmp);
        for q in [0.11, 0.5, 0.9, 0.99, 1.0] {
            let exact = differences[((q * 1e4) as usize).max(1) - 1];
            let estimate = closeness.quantile(q).expect("paths");
            assert!(
                (estimate / exact).log2().abs() <= 1.01 / 128.0,
                "{q}: {estimate}, {exact}"
            );
        }
        assert_eq!(closeness.quantile(0.1), Some(0.0));
    }

    #[test]
    fn nothing_and_the_ends_of_the_scale() {
        let mut closeness = Closeness::default();
        assert_eq!(closeness.quantile(0.5), None);
        closeness.add(HERE, grey(1.0), grey(1.0));
        assert_eq!(
            (closeness.quantile(0.5), closeness.worst),
            (Some(0.0), None)
        );
        closeness.add(HERE, grey(1.0), grey(0.0));
        closeness.add(HERE, grey(1.0), grey(-1.0));
        assert!(closeness.quantile(1.0).is_some_and(|d| d > 0.99 && d < 1.0));
        assert_eq!(closeness.worst.map(|w| w.difference), Some(2.0));
    }
}
