//! Scrambled points are nets: the samples of a group are distributed as evenly as the definition says.

use super::super::{sobol, sobol_quarters};
use super::Sampler;
use crate::sample::GROUPS;

/// Degrees of the dimensions' polynomials less one, in the order of the words: a set of dimensions has a
/// (t, k, s)-net in every 2ᵏ points with t their sum (Sobol 1967; Niederreiter, J. Number Theory 30, 1988).
const QUALITY: [u32; 4] = [2, 0, 0, 1];

/// Words of 2ᵏ consecutive samples of a group, from number `start` of the group.
fn points(sampler: Sampler, [pixel, block, group]: [u32; 3], start: u32, k: u32) -> Vec<[u32; 4]> {
    let index = |i| (start + i) * GROUPS + group;
    (0..1 << k)
        .map(|i| sampler(pixel, index(i), block, 11))
        .collect()
}

/// Every way to distribute `digits` over four dimensions, with none outside `set`.
fn shares(set: u32, digits: u32) -> impl Iterator<Item = [u32; 4]> {
    let base = digits + 1;
    (0..base.pow(4)).filter_map(move |code| {
        let share = [0, 1, 2, 3].map(|i| code / base.pow(i) % base);
        let inside = (0..4).all(|i| set >> i & 1 == 1 || share[i] == 0);
        (inside && share.iter().sum::<u32>() == digits).then_some(share)
    })
}

/// The first `digits` binary digits after the point.
fn first(word: u32, digits: u32) -> usize {
    (u64::from(word) >> (32 - digits)) as usize
}

/// Whether each elementary interval of volume 2ᵗ⁻ᵏ in these dimensions contains 2ᵗ of the points.
fn is_net(points: &[[u32; 4]], set: u32, t: u32) -> bool {
    let k = points.len().ilog2();
    shares(set, k.saturating_sub(t)).all(|share| {
        let mut counts = vec![0; 1 << share.iter().sum::<u32>()];
        for point in points {
            let interval = point.iter().zip(share);
            let interval = interval.fold(0, |cell, (&word, d)| (cell << d) | first(word, d));
            counts[interval] += 1;
        }
        counts
            .iter()
            .all(|&n| n << (k.saturating_sub(t)) == points.len())
    })
}

/// The sets of dimensions in which points are less even than Sobol's.
fn faults(points: &[[u32; 4]]) -> Vec<u32> {
    let t = |set: u32| {
        (0..4)
            .filter(|i| set >> i & 1 == 1)
            .map(|i| QUALITY[i])
            .sum()
    };
    (1..16)
        .filter(|&set| !is_net(points, set, t(set)))
        .collect()
}

const PLACES: [[u32; 3]; 4] = [[0, 0, 0], [76_800, 1, 1], [5, 2, 0], [76_799, 3000, 1]];

/// From the first sample on, and in aligned runs further out, where indices are above 2²⁴.
#[test]
fn samples_of_a_group_are_nets() {
    for place in PLACES {
        for k in 0..=8 {
            for start in [0, 3 << k, 1 << 24, (1 << 30) + (7 << k)] {
                let points = points(sobol::sampler_block, place, start, k);
                assert_eq!(faults(&points), [0; 0], "{place:?}: 2^{k} from {start}");
            }
        }
    }
}

/// Four groups: samples of group 1 are those of indices 1, 5, 9 …
#[test]
fn quarters_of_the_samples_are_nets() {
    let group: Sampler =
        |p, s, b, e| sobol_quarters::sampler_block(p, s / GROUPS * 4 + s % GROUPS, b, e);
    for place in PLACES {
        let faults = faults(&points(group, place, 0, 6));
        assert_eq!(faults, [0; 0], "{place:?}");
    }
}

/// Many points in one dimension and in the best two.
#[test]
fn thousands_of_samples_are_nets() {
    let points = points(sobol::sampler_block, PLACES[1], 0, 13);
    for (set, t) in [(1, 0), (2, 0), (4, 0), (8, 0), (6, 0)] {
        assert!(is_net(&points, set, t), "{set:04b}");
    }
}

#[test]
fn points_that_are_no_net_are_found() {
    let sobol = sobol::sampler_block;
    let planted: [(&str, Sampler); 4] = [
        ("random numbers", super::super::random::sampler_block),
        ("groups mixed up", |p, s, b, e| {
            sobol::sampler_block(p, s ^ (s >> 1 & 1), b, e)
        }),
        ("a dimension twice", |p, s, b, e| {
            let [x, y, z, _] = sobol::sampler_block(p, s, b, e);
            [x, y, z, x]
        }),
        ("one bit of one word", |p, s, b, e| {
            let [x, y, z, w] = sobol::sampler_block(p, s, b, e);
            [x, y, z ^ (u32::from(s == 6) << 31), w]
        }),
    ];
    for (name, sampler) in planted {
        assert!(
            !faults(&points(sampler, PLACES[0], 0, 6)).is_empty(),
            "{name}"
        );
    }
    assert_eq!(faults(&points(sobol, PLACES[0], 0, 6)), [0; 0]);
}
