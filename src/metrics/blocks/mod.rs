//! Tests whether two pictures agree within their standard errors: a z-test on the means of 25×25 blocks.
//!
//! Tested pixel by pixel, a correct renderer would fail (fireflies have no normal distribution), and 1 % of bias would
//! pass (it is hidden by a pixel's noise). The mean of a block of 625 pixels is close to normal, and its error 25 times
//! smaller. Where the errors are themselves estimates with few degrees of freedom per pixel, the test uses Student's t,
//! with degrees of freedom from all pixels of a block together. Fireflies so rare that a block has only a few of them
//! still violate the assumption, and cause more rejections than the level allows.

mod area;
mod estimate;

use super::MetricsError;
use super::pair::same_size;
pub use area::Block;
use area::{Area, spans};
pub use estimate::{Estimate, Stderr};

/// The level of the whole test: the probability of rejecting two pictures that agree.
pub const ALPHA: f64 = 1e-3;

/// The result of the test.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockTest {
    blocks: Vec<Block>,
    level: f64,
}

/// The z-test of every block and channel, with the total level `alpha` (in (0, 1); usually [`ALPHA`]).
pub fn z_test(a: &Estimate, b: &Estimate, alpha: f64) -> Result<BlockTest, MetricsError> {
    if !(alpha > 0.0 && alpha < 1.0) {
        return Err(MetricsError::Level(alpha));
    }
    a.check("first picture", "first picture's standard errors")?;
    b.check("second picture", "second picture's standard errors")?;
    same_size((a.mean, "first picture"), (b.mean, "second picture"))?;
    let [columns, rows] = [a.mean.width, a.mean.height].map(|size| spans(size as usize));
    let areas = rows
        .iter()
        .flat_map(|&rows| columns.iter().map(move |&columns| Area { columns, rows }));
    let blocks: Vec<Block> = areas.flat_map(|area| area.blocks(a, b)).collect();
    // 1 − (1 − α)^(1/m) (Šidák 1967)
    let level = -((-alpha).ln_1p() / blocks.len() as f64).exp_m1();
    Ok(BlockTest { blocks, level })
}

impl BlockTest {
    /// Row by row, the channels of a block together; at least three.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// A block's level: a smaller p rejects it.
    pub fn level(&self) -> f64 {
        self.level
    }

    pub fn passes(&self) -> bool {
        self.rejected() == 0
    }

    /// Blocks, counted once in each channel, that differ by more than chance explains.
    pub fn rejected(&self) -> usize {
        self.blocks.iter().filter(|b| b.p < self.level).count()
    }

    /// The block with the smallest p; among equals, the one with the largest |z|.
    pub fn worst(&self) -> Block {
        let worse = |a: &Block, b: &Block| (a.p, -a.z.abs()) < (b.p, -b.z.abs());
        let by_p = |worst: Block, b: &Block| if worse(b, &worst) { *b } else { worst };
        self.blocks[1..].iter().fold(self.blocks[0], by_p)
    }

    /// Mean and standard deviation of z over the blocks that have a standard error: near 0 and 1 if the errors are
    /// correct. `None` with fewer than two of them.
    ///
    /// The deviation of m independent z is itself uncertain by 1/√(2m); if the channels share noise, m is the number of
    /// blocks. With ν degrees of freedom it is √(ν/(ν − 2)).
    pub fn spread(&self) -> Option<[f64; 2]> {
        let noisy = self.blocks.iter().filter(|b| b.stderr > 0.0);
        let z: Vec<f64> = noisy.map(|b| b.z).collect();
        let n = z.len() as f64;
        let mean = z.iter().sum::<f64>() / n;
        let variance = z.iter().map(|z| (z - mean) * (z - mean)).sum::<f64>() / (n - 1.0);
        (z.len() > 1).then(|| [mean, variance.sqrt()])
    }
}
