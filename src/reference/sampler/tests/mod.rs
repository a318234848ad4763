//! The hash compared with exact integers computed elsewhere, numbers with chance, Sobol points with their definition.

mod chance;
mod digits;
mod nets;
mod padding;

use super::pcg4d::pcg4d;
use super::{bsdf_block, camera_block, light_block, roulette_block, unit_float};
use crate::reference::math::Real;

/// A sampler: pixel, sample index, block and seed to four words.
type Sampler = fn(u32, u32, u32, u32) -> [u32; 4];

/// Probability that a family of tests rejects a perfect sampler.
const SIGNIFICANCE: f64 = 1e-3;

/// The tests of a family that reject at the level that Šidák leaves each of them.
fn rejections(family: Vec<(String, f64)>) -> Vec<(String, f64)> {
    let level = 1.0 - (1.0 - SIGNIFICANCE).powf(1.0 / family.len() as f64);
    family.into_iter().filter(|(_, p)| *p < level).collect()
}

/// Values of a few lines of Python in whole numbers, with one remainder per operation:
/// `m = lambda x,y,z,w: (x:=(x+y*w)%2**32, y:=(y+z*x)%2**32, z:=(z+x*y)%2**32, (w+y*z)%2**32)`
/// `m(*[a ^ a//65536 for a in m(*[(a*1664525+1013904223) % 2**32 for a in v])])`
#[test]
fn pcg4d_equals_the_same_hash_in_python() {
    let rows = [
        ([0, 0, 0, 0], [251852841, 760645481, 850445371, 3542436074]),
        ([1, 2, 3, 4], [908250390, 4044648920, 3775961919, 45698095]),
        (
            [u32::MAX; 4],
            [2538526866, 3222658151, 2677364576, 2713428488],
        ),
        (
            [76800, 255, 17, 12345],
            [660859839, 3410631259, 1264953972, 2878031843],
        ),
    ];
    for (v, hash) in rows {
        assert_eq!(pcg4d(v), hash);
    }
}

#[test]
fn unit_floats_stay_below_one() {
    assert_eq!(unit_float::<f32>(0), 0.0);
    assert_eq!(unit_float::<f32>(u32::MAX), 1.0 - 2f32.powi(-24));
    assert_eq!(
        unit_float::<f32>(u32::MAX).f64(),
        unit_float::<f64>(u32::MAX)
    );
    assert_eq!(unit_float::<f64>(0x8000_0100), 0.5 + 2f64.powi(-24));
}

#[test]
fn no_block_serves_two_purposes() {
    let mut blocks = vec![camera_block()];
    blocks.extend((0..1000).flat_map(|b| [light_block(b), bsdf_block(b), roulette_block(b)]));
    assert_eq!(blocks, (0..3001).collect::<Vec<_>>());
}
