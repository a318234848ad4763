//! The findings of three comparisons.

use vkpt::metrics::paired::{Comparison, Verdict};
use vkpt::report::human::{p_value, thousands};
use vkpt::sample::Address;

/// The pairs of renderers, in the order of [`Findings::pairs`].
pub const PAIRS: [&str; 3] = ["GPU – cpu-f32", "GPU – cpu-f64", "cpu-f32 – cpu-f64"];

/// The comparisons of one run.
pub struct Findings {
    pub pairs: [Comparison; PAIRS.len()],
    /// The device is a CPU driver, which rounds as the reference does: a difference in a bit is an error.
    pub correctly_rounded: bool,
    /// The command lines that show one path on the device and on cpu-f32, and on both references.
    pub show: [String; 2],
}

impl Findings {
    /// Failures, one line each.
    pub fn failures(&self) -> Vec<String> {
        let bits = self.different_bits();
        let bias = PAIRS.iter().zip(&self.pairs).filter_map(|(name, pair)| {
            let Verdict::Biased(p) = pair.diverged.verdict() else {
                return None;
            };
            Some(format!(
                "{name}: the mean radiance of the diverged paths differs ({})",
                p_value(p)
            ))
        });
        bits.into_iter().chain(bias).collect()
    }

    fn different_bits(&self) -> Option<String> {
        let pair = &self.pairs[0];
        let first = pair.first_unequal.filter(|_| self.correctly_rounded)?;
        Some(format!(
            "a CPU's Vulkan driver must equal cpu-f32 in every bit; {} of {} paths differ, the first at pixel {},{}, \
             sample {}: {}",
            thousands(pair.paths - pair.equal),
            thousands(pair.paths),
            first.pixel[0],
            first.pixel[1],
            first.index,
            self.command(0, first)
        ))
    }

    /// The command line that shows a path that a pair differs in.
    pub fn command(&self, pair: usize, address: Address) -> String {
        // If the device equals cpu-f32, the difference is between the references.
        let on_device = pair == 0 || (pair == 1 && !self.pairs[0].is_equal());
        let show = &self.show[usize::from(!on_device)];
        let [x, y] = address.pixel;
        format!("{show} --trace {x},{y},{}", address.index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vkpt::sample::Path;

    /// Forty samples: sample 20 is off by a bit in the pair `bit`, all diverge in the pair `bias`, one side brighter.
    fn findings(bit: usize, bias: usize, correctly_rounded: bool) -> Findings {
        let mut pairs: [Comparison; PAIRS.len()] = Default::default();
        for (k, pair) in pairs.iter_mut().enumerate() {
            for index in 0..40 {
                let path = |x: f64, signature| Path {
                    radiance: [x; 3],
                    signature,
                };
                let off = k == bit && index == 20;
                let a = path(if off { 1.0f64.next_up() } else { 1.0 }, 0);
                let wave = 1.1 + 0.01 * f64::from(index % 3);
                let b = if k == bias {
                    path(wave, 1)
                } else {
                    path(1.0, 0)
                };
                let address = Address {
                    pixel: [7, 8],
                    index,
                };
                pair.add(address, &a, &b);
            }
        }
        Findings {
            pairs,
            correctly_rounded,
            show: ["vkpt a.txt", "vkpt a.txt --device cpu-f64"].map(str::to_owned),
        }
    }

    #[test]
    fn a_bit_counts_on_a_cpu_driver_and_has_an_address() {
        let failures = findings(0, 9, true).failures();
        assert_eq!(failures.len(), 1, "{failures:?}");
        let message =
            "1 of 40 paths differ, the first at pixel 7,8, sample 20: vkpt a.txt --trace 7,8,20";
        assert!(failures[0].ends_with(message), "{failures:?}");
        assert!(findings(0, 9, false).failures().is_empty());
        // f64 may differ.
        assert!(findings(1, 9, true).failures().is_empty());
    }

    #[test]
    fn a_bias_counts_everywhere() {
        for pair in [1, 2] {
            let failures = findings(9, pair, true).failures();
            assert_eq!(failures.len(), 1, "{failures:?}");
            assert!(failures[0].starts_with(PAIRS[pair]), "{failures:?}");
        }
    }
}
