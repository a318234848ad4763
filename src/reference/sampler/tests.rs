//! The hash against exact integers computed elsewhere, its numbers against chance.

use statrs::distribution::{ChiSquared, ContinuousCDF};

use super::random::{pcg4d, sampler_block};
use crate::reference::math::Real;

use super::{bsdf_block, camera_block, light_block, roulette_block, unit_float};

/// Values of a few lines of Python in whole numbers, remainders taken once an operation:
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

type Sampler = fn(u32, u32, u32, u32) -> [u32; 4];

/// Numbers a test; 256 cells then hold 256 each on average.
const N: u32 = 1 << 16;
/// Probability that the whole family rejects a perfect sampler.
const SIGNIFICANCE: f64 = 1e-3;

/// Probability that chance alone fills 256 equal cells at least this unevenly (Pearson's statistic,
/// 255 degrees of freedom), or at least this evenly, whichever is smaller.
fn p_value(cells: impl Iterator<Item = u32>) -> f64 {
    let mut counts = [0u32; 256];
    let mut n = 0.0;
    for cell in cells {
        counts[cell as usize] += 1;
        n += 1.0;
    }
    let expected = n / 256.0;
    let chi2: f64 = counts
        .iter()
        .map(|&k| (f64::from(k) - expected).powi(2) / expected)
        .sum();
    let law = ChiSquared::new(255.0).expect("255 > 0");
    (2.0 * law.cdf(chi2).min(law.sf(chi2))).min(1.0)
}

/// 16 × 16 cells of a pair of words.
fn pair(a: u32, b: u32) -> u32 {
    (a >> 28) * 16 + (b >> 28)
}

/// (name, p) of every test of the family. `at` maps a counter to the place of a block: each way
/// in which a renderer walks through the sampler's arguments.
fn family(sampler: Sampler) -> Vec<(String, f64)> {
    type Walk = (&'static str, fn(u32) -> [u32; 4], [u32; 4]);
    // the place of number i, and the step to the neighbour that it must be independent of
    let walks: [Walk; 7] = [
        ("samples", |i| [1234, i, 2, 0], [0, 1, 0, 0]),
        ("pixels", |i| [i, 0, 0, 0], [1, 0, 0, 0]),
        ("rows", |i| [i, 5, 1, 0], [400, 0, 0, 0]),
        ("blocks", |i| [777, 3, i, 0], [0, 0, 1, 0]),
        ("bounces", |i| [i, 1, 2, 7], [0, 0, 3, 0]),
        ("seeds", |i| [42, 9, 4, i], [0, 0, 0, 1]),
        ("picture", |i| [i >> 4, i & 15, 0, 1], [0, 0, 0, 1]),
    ];
    let mut family = vec![];
    for (name, place, step) in walks {
        let block = move |i: u32| {
            let [p, s, b, e] = place(i);
            sampler(p, s, b, e)
        };
        let neighbour = move |i: u32| {
            let (v, d) = (place(i), step);
            sampler(v[0] + d[0], v[1] + d[1], v[2] + d[2], v[3] + d[3])
        };
        for a in 0..4 {
            family.push((
                format!("{name}: word {a}"),
                p_value((0..N).map(|i| block(i)[a] >> 24)),
            ));
            // the lowest of the 24 bits that are used
            family.push((
                format!("{name}: low bits of {a}"),
                p_value((0..N).map(|i| (block(i)[a] >> 8) & 255)),
            ));
            for b in 0..4 {
                if a < b {
                    let cells = (0..N).map(|i| pair(block(i)[a], block(i)[b]));
                    family.push((format!("{name}: words {a}, {b}"), p_value(cells)));
                }
                // every second one where the neighbour of i is i + 1: a pair is used once
                let cells = (0..N)
                    .map(|i| 2 * i)
                    .map(|i| pair(block(i)[a], neighbour(i)[b]));
                family.push((format!("{name}: word {a}, next {b}"), p_value(cells)));
            }
        }
        // all four at once, 4⁴ cells
        let cells = (0..N).map(|i| block(i).iter().fold(0, |cell, x| cell * 4 + (x >> 30)));
        family.push((format!("{name}: block"), p_value(cells)));
    }
    family
}

/// The tests of the family that reject at the level that Šidák leaves each of them.
fn rejections(sampler: Sampler) -> Vec<(String, f64)> {
    let family = family(sampler);
    let level = 1.0 - (1.0 - SIGNIFICANCE).powf(1.0 / family.len() as f64);
    family.into_iter().filter(|(_, p)| *p < level).collect()
}

#[test]
fn random_numbers_are_uniform_and_independent() {
    assert_eq!(rejections(sampler_block), vec![]);
}

#[test]
fn the_family_rejects_planted_faults() {
    let faults: [(&str, Sampler); 5] = [
        ("1 % too large", |p, s, b, e| {
            sampler_block(p, s, b, e).map(|x| (x as f32 * 1.01) as u32)
        }),
        ("two equal words", |p, s, b, e| {
            let [x, y, z, _] = sampler_block(p, s, b, e);
            [x, y, z, x]
        }),
        ("the seed unused", |p, s, b, _| sampler_block(p, s, b, 0)),
        ("stratified in the sample index", |p, s, b, e| {
            let [_, y, z, w] = sampler_block(p, s, b, e);
            [s.wrapping_mul(2654435769), y, z, w]
        }),
        ("the block unused", |p, s, _, e| sampler_block(p, s, 0, e)),
    ];
    for (name, sampler) in faults {
        assert!(!rejections(sampler).is_empty(), "{name} passes");
    }
}
