//! Every sample is in one part, and parts are about the same.

use proptest::prelude::*;
use vkpt_cli::farm::{Share, rounds, shares};

/// Whether the shares, one after the other, are those samples.
fn covers(shares: &[Share], samples: Share) -> bool {
    let ends = shares.iter().map(|s| s.end);
    let begins = [samples.start].into_iter().chain(ends);
    shares
        .iter()
        .zip(begins)
        .all(|(s, begin)| s.start == begin && s.end > s.start)
        && shares.last().map(|s| s.end) == Some(samples.end)
}

#[test]
fn shares_of_powers_of_two_are_the_same_and_begin_at_whole_blocks() {
    let all = shares(0..65536, 64);
    assert_eq!(all.len(), 64);
    assert!(all.iter().all(|s| s.len() == 1024));
    assert_eq!(shares(0..8, 4), [0..2, 2..4, 4..6, 6..8]);
    assert_eq!(shares(0..2, 4), [0..1, 1..2]);
    assert_eq!(shares(5..5, 4), []);
    assert!(shares(0..100_000, 10).iter().all(|s| s.start % 256 == 0));
}

#[test]
fn rounds_double_until_all_samples_are_rendered() {
    let ends = |spp, tasks| -> Vec<u32> {
        let all = rounds(spp, tasks).into_iter();
        all.map(|round| round.last().expect("a share").end)
            .collect()
    };
    assert_eq!(ends(65536, 64), [16384, 32768, 65536]);
    assert_eq!(ends(20000, 64), [16384, 20000]);
    assert_eq!(ends(100, 64), [100]);
    assert_eq!(ends(u32::MAX, 10_000).last(), Some(&u32::MAX));
    assert_eq!(ends(u32::MAX, u32::MAX >> 8).len(), 2);
}

proptest! {
    #[test]
    fn every_sample_is_in_one_share(start in 0..u32::MAX, count in 1..u32::MAX, tasks in 1..2000_u32) {
        let samples = start..start.saturating_add(count);
        let shares = shares(samples.clone(), tasks);
        prop_assert!(covers(&shares, samples));
        prop_assert!(shares.len() <= tasks as usize);
        // All but the last, which has the rest.
        let sizes = shares[..shares.len() - 1].iter().map(|s| s.len());
        if let (Some(least), Some(most)) = (sizes.clone().min(), sizes.max()) {
            prop_assert!(most - least <= if least < 256 { 1 } else { 256 }, "{least} to {most}");
        }
    }

    #[test]
    fn every_sample_is_in_one_round(spp in 1..u32::MAX, tasks in 1..1000_u32) {
        let all: Vec<Share> = rounds(spp, tasks).concat();
        prop_assert!(covers(&all, 0..spp));
    }
}
