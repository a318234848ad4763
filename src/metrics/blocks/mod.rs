//! Do two pictures agree within their standard errors? A z-test on the means of 25×25 blocks.
//!
//! Tested pixel by pixel, a correct renderer would fail (fireflies have no normal distribution), and 1 % of bias
//! would pass (it hides below a pixel's noise). The mean of a block of 625 pixels is close to normal, and its
//! error 25 times smaller. Where the errors are estimates themselves, of few degrees of freedom a pixel, the test is one
//! by Student's t, whose degrees of freedom come from all pixels of a block together. Fireflies so rare that a block has but a few still break that, and reject more often
//! than the level says.

mod area;
mod estimate;

use super::MetricsError;
use super::pair::same_size;
pub use area::Block;
use area::{Area, spans};
pub use estimate::{Estimate, Stderr};

/// The level of the whole test: how often it rejects two pictures that agree.
pub const ALPHA: f64 = 1e-3;

/// What the test found.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockTest {
    blocks: Vec<Block>,
    level: f64,
}

/// The z-test of every block and channel, of the level `alpha` in all (in (0, 1); usually [`ALPHA`]).
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

    /// The block of the least p; of equals that of the largest |z|.
    pub fn worst(&self) -> Block {
        let worse = |a: &Block, b: &Block| (a.p, -a.z.abs()) < (b.p, -b.z.abs());
        let by_p = |worst: Block, b: &Block| if worse(b, &worst) { *b } else { worst };
        self.blocks[1..].iter().fold(self.blocks[0], by_p)
    }

    /// Mean and standard deviation of z over the blocks that have a standard error: near 0 and 1 if the errors
    /// are honest. `None` with fewer than two of them.
    ///
    /// The deviation of m independent z is itself uncertain by 1/√(2m); noise that the channels share makes m
    /// the number of blocks. Of ν degrees of freedom it is √(ν/(ν − 2)).
    pub fn spread(&self) -> Option<[f64; 2]> {
        let noisy = self.blocks.iter().filter(|b| b.stderr > 0.0);
        let z: Vec<f64> = noisy.map(|b| b.z).collect();
        let n = z.len() as f64;
        let mean = z.iter().sum::<f64>() / n;
        let variance = z.iter().map(|z| (z - mean) * (z - mean)).sum::<f64>() / (n - 1.0);
        (z.len() > 1).then(|| [mean, variance.sqrt()])
    }
}
