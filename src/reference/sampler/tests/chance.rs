//! Tests that numbers are uniform and independent of one another, by Pearson's statistic over walks through the arguments.

use statrs::distribution::{ChiSquared, ContinuousCDF};

use super::super::{random, sobol, sobol_quarters};
use super::{Sampler, rejections};
use crate::sample::GROUPS;

/// Numbers per test; 256 cells then contain 256 each on average.
const N: u32 = 1 << 16;

/// A way in which a renderer walks through the sampler's arguments: the place of number i, and the step to the
/// neighbour of which it must be independent.
type Walk = (&'static str, fn(u32) -> [u32; 4], [u32; 4]);

/// The walks on which any sampler draws by chance: the index of the sample within its group is constant.
const WALKS: [Walk; 7] = [
    ("pixels", |i| [i, 0, 0, 0], [1, 0, 0, 0]),
    ("rows", |i| [i, 5, 1, 0], [400, 0, 0, 0]),
    ("blocks", |i| [777, 3, i, 0], [0, 0, 1, 0]),
    ("bounces", |i| [i, 1, 2, 7], [0, 0, 3, 0]),
    ("seeds", |i| [42, 9, 4, i], [0, 0, 0, 1]),
    ("groups", |i| [i, 0, 3, 5], [0, 1, 0, 0]),
    ("far", |i| [i, (1 << 24) + 5, 2, 3], [0, 0, 1, 0]),
];

/// The walks on which only random numbers are independent.
const SAMPLES: [Walk; 2] = [
    ("samples", |i| [1234, i, 2, 0], [0, 1, 0, 0]),
    ("picture", |i| [i >> 4, i & 15, 0, 1], [0, 0, 0, 1]),
];

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

/// (name, p) of every test on these walks.
fn family(sampler: Sampler, walks: &[Walk]) -> Vec<(String, f64)> {
    let mut family = vec![];
    for &(name, place, step) in walks {
        let at = |[p, s, b, e]: [u32; 4]| sampler(p, s, b, e);
        let blocks: Vec<_> = (0..N).map(|i| at(place(i))).collect();
        let beside = |v: [u32; 4]| [0, 1, 2, 3].map(|k| v[k] + step[k]);
        let neighbours: Vec<_> = (0..N).map(|i| at(beside(place(2 * i)))).collect();
        let twice: Vec<_> = (0..N).map(|i| at(place(2 * i))).collect();
        let block = |i: u32| blocks[i as usize];
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
                // every second one if the neighbour of i is i + 1: a pair is used once
                let both = twice.iter().zip(&neighbours);
                let cells = both.map(|(word, next)| pair(word[a], next[b]));
                family.push((format!("{name}: word {a}, next {b}"), p_value(cells)));
            }
        }
        // all four at once, 4⁴ cells
        let cells = (0..N).map(|i| block(i).iter().fold(0, |cell, x| cell * 4 + (x >> 30)));
        family.push((format!("{name}: block"), p_value(cells)));
    }
    family
}

fn all_walks() -> Vec<Walk> {
    [&WALKS[..], &SAMPLES].concat()
}

#[test]
fn random_numbers_are_uniform_and_independent() {
    let family = family(random::sampler_block, &all_walks());
    assert_eq!(rejections(family), vec![]);
}

#[test]
fn sobol_points_are_uniform_and_independent_of_pixel_block_seed_and_group() {
    let family = family(sobol::sampler_block, &WALKS);
    assert_eq!(rejections(family), vec![]);
}

/// From each of four groups to the next, and to the one after that.
const QUARTERS: [Walk; 2] = [
    ("next quarter", |i| [i, 3, 2, 5], [0, 1, 0, 0]),
    ("opposite quarter", |i| [i, 1, 3, 5], [0, 2, 0, 0]),
];

#[test]
fn quarters_are_independent() {
    let family = family(sobol_quarters::sampler_block, &QUARTERS);
    assert_eq!(rejections(family), vec![]);
}

/// Two groups are not four: the family detects it.
#[test]
fn halves_have_no_independent_quarters() {
    let family = family(sobol::sampler_block, &QUARTERS);
    assert!(!rejections(family).is_empty());
}

/// Sobol samples are too even for chance.
#[test]
fn the_family_rejects_the_evenness_of_sobol_points() {
    assert!(!rejections(family(sobol::sampler_block, &SAMPLES)).is_empty());
}

#[test]
fn the_family_rejects_planted_faults() {
    let faults: [(&str, Sampler); 5] = [
        ("1 % too large", |p, s, b, e| {
            random::sampler_block(p, s, b, e).map(|x| (x as f32 * 1.01) as u32)
        }),
        ("two equal words", |p, s, b, e| {
            let [x, y, z, _] = random::sampler_block(p, s, b, e);
            [x, y, z, x]
        }),
        ("the seed unused", |p, s, b, _| {
            random::sampler_block(p, s, b, 0)
        }),
        ("stratified in the sample index", |p, s, b, e| {
            let [_, y, z, w] = random::sampler_block(p, s, b, e);
            [s.wrapping_mul(2654435769), y, z, w]
        }),
        ("the block unused", |p, s, _, e| {
            random::sampler_block(p, s, 0, e)
        }),
    ];
    for (name, sampler) in faults {
        let family = family(sampler, &all_walks());
        assert!(!rejections(family).is_empty(), "{name} passes");
    }
}

#[test]
fn the_family_rejects_faults_planted_into_sobol_points() {
    let faults: [(&str, Sampler); 4] = [
        ("the pixel unused", |_, s, b, e| {
            sobol::sampler_block(0, s, b, e)
        }),
        ("the block unused", |p, s, _, e| {
            sobol::sampler_block(p, s, 0, e)
        }),
        ("one scramble for all groups", |p, s, b, e| {
            sobol::sampler_block(p, s / GROUPS * GROUPS, b, e)
        }),
        ("two dimensions scrambled alike", |p, s, b, e| {
            let [x, _, z, w] = sobol::sampler_block(p, s, b, e);
            [x, x, z, w]
        }),
    ];
    for (name, sampler) in faults {
        assert!(
            !rejections(family(sampler, &WALKS)).is_empty(),
            "{name} passes"
        );
    }
}
