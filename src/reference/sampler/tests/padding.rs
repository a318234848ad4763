//! Blocks of one path must be paired at random, which is the purpose of the index shuffle.
//!
//! Samples 2i and 2i + 1 of a group lie in different halves of every dimension of every block. So for a pair of dimensions of
//! two blocks either both of them lie in like halves or both in unlike ones; the shuffles decide which like a coin,
//! independently for each i. Among 32 such pairs of samples, the number that lie in like halves is binomial.

use statrs::distribution::{Binomial, ChiSquared, ContinuousCDF, Discrete};

use super::super::owen::owen_scramble;
use super::super::pcg4d::pcg4d;
use super::super::sobol::{self};
use super::super::{bsdf_block, light_block, roulette_block};
use super::{Sampler, rejections};
use crate::sample::GROUPS;

const PIXELS: u32 = 2000;
const PAIRS: u32 = 32;

/// How many of the pairs of samples of this pixel lie in like halves of word a of one block and word b of another.
fn like(sampler: Sampler, pixel: u32, blocks: [u32; 2], [a, b]: [usize; 2]) -> usize {
    let half = |i: u32, block, word| sampler(pixel, 2 * i * GROUPS, block, 3)[word] >> 31;
    let pairs = (0..PAIRS).filter(|&i| half(i, blocks[0], a) == half(i, blocks[1], b));
    pairs.count()
}

/// Pearson's p-value of these counts for the binomial law; rare counts share a cell at either end.
fn p_value(likes: impl Iterator<Item = usize>) -> f64 {
    const CELLS: std::ops::RangeInclusive<usize> = 9..=23;
    let law = Binomial::new(0.5, PAIRS.into()).expect("a law");
    let cell = |n: usize| n.clamp(*CELLS.start(), *CELLS.end());
    let mut expected = [0.0; PAIRS as usize];
    for n in 0..=PAIRS as usize {
        expected[cell(n)] += f64::from(PIXELS) * law.pmf(n as u64);
    }
    let mut counts = [0.0; PAIRS as usize];
    likes.for_each(|n| counts[cell(n)] += 1.0);
    let terms = CELLS.map(|n| (counts[n] - expected[n]).powi(2) / expected[n]);
    let freedom = CELLS.count() as f64 - 1.0;
    ChiSquared::new(freedom).expect("cells").sf(terms.sum())
}

/// (name, p) for each pair of words of three pairs of blocks.
fn family(sampler: Sampler) -> Vec<(String, f64)> {
    let pairs = [
        [light_block(0), bsdf_block(0)],
        [bsdf_block(0), bsdf_block(1)],
        [light_block(2), roulette_block(2)],
    ];
    let words = (0..16).map(|i| [i / 4, i % 4]);
    let tests = pairs
        .into_iter()
        .flat_map(|b| words.clone().map(move |w| (b, w)));
    tests
        .map(|(blocks, words)| {
            let likes = (0..PIXELS).map(|pixel| like(sampler, pixel, blocks, words));
            (
                format!("blocks {blocks:?}, words {words:?}"),
                p_value(likes),
            )
        })
        .collect()
}

#[test]
fn blocks_meet_by_chance() {
    assert_eq!(rejections(family(sobol::sampler_block)), vec![]);
}

/// Radical inverses, scrambled, with an index that all blocks shuffle alike, or that none shuffles.
#[test]
fn blocks_without_shuffles_of_their_own_are_noticed() {
    let alike: Sampler = |p, s, b, e| {
        let shuffle = pcg4d([p, s % GROUPS, 0, e])[0];
        let index = owen_scramble((s / GROUPS).reverse_bits(), shuffle).reverse_bits();
        pcg4d([p, s % GROUPS, b, e]).map(|seed| owen_scramble(index, seed).reverse_bits())
    };
    let none: Sampler = |p, s, b, e| {
        let scramble = pcg4d([p, s % GROUPS, b, e]);
        scramble.map(|seed| owen_scramble(s / GROUPS, seed).reverse_bits())
    };
    for sampler in [alike, none] {
        assert_eq!(rejections(family(sampler)).len(), 48);
    }
}
