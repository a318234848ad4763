//! Compares two renderers on the same samples, path by path: which paths stay together, how close they are, and whether
//! diverged paths are biased. Memory does not depend on the number of paths.

mod bias;
mod closeness;

pub use bias::{Diverged, Verdict};
pub use closeness::{Closeness, DARK, Worst, relative_difference};

use crate::sample::{Address, Path};

/// Statistics of all paths so far.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    pub paths: u64,
    /// Same decisions, and the same radiance to the bit.
    pub equal: u64,
    /// The first path that is not equal to the bit.
    pub first_unequal: Option<Address>,
    /// Same decisions: shape, light, arrival, lobe and roulette at each vertex.
    pub together: u64,
    /// The first path that diverged.
    pub first_diverged: Option<Address>,
    /// Samples with a NaN or an infinity on either side; the film drops them, here they count as 0.
    pub broken: u64,
    /// Of the paths that stay together and contribute light.
    pub closeness: Closeness,
    /// Of the diverged paths.
    pub diverged: Diverged,
}

impl Comparison {
    /// Adds one sample as computed by both renderers.
    pub fn add(&mut self, address: Address, a: &Path, b: &Path) {
        self.paths += 1;
        let together = a.signature == b.signature;
        if together && same_bits(a.radiance, b.radiance) {
            self.equal += 1;
        } else {
            self.first_unequal.get_or_insert(address);
        }
        let whole = |x: [f64; 3]| x.iter().all(|c| c.is_finite());
        self.broken += u64::from(!whole(a.radiance) || !whole(b.radiance));
        let [a, b] = [a, b].map(|p| {
            if whole(p.radiance) {
                p.radiance
            } else {
                [0.0; 3]
            }
        });
        if together {
            self.together += 1;
            self.closeness.add(address, a, b);
        } else {
            self.first_diverged.get_or_insert(address);
            self.diverged.add([0, 1, 2].map(|c| a[c] - b[c]));
        }
    }

    /// Whether every path is equal to the bit.
    pub fn is_equal(&self) -> bool {
        self.equal == self.paths
    }
}

/// All NaNs are equal: no standard defines their payload.
fn same_bits(a: [f64; 3], b: [f64; 3]) -> bool {
    let same = |(a, b): (f64, f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    a.into_iter().zip(b).all(same)
}
