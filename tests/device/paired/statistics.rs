//! The comparison itself, on paths made up for it.

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::metrics::paired::{Comparison, Diverged, Verdict};
use vkpt::sample::{Address, Path};

/// Uniform in [0, 1): the top 53 bits of a 64-bit linear congruential generator (Knuth's MMIX).
struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 * 2f64.powi(-53)
    }

    /// Radiance of a path: 0 in two of five, else a density of 2.5 x^-3.5 above 1: no fourth moment.
    fn radiance(&mut self) -> f64 {
        if self.next() < 0.4 {
            0.0
        } else {
            (1.0 - self.next()).powf(-0.4)
        }
    }
}

fn address(i: u32) -> Address {
    Address {
        pixel: [i % 1000, i / 1000 % 1000],
        index: i / 1_000_000,
    }
}

#[test]
fn one_sample_in_a_million_is_named() {
    let mut pair = Comparison::default();
    for i in 0..1_000_000 {
        let path = Path {
            radiance: [0.5, 1.0, f64::from(i)],
            signature: i,
        };
        let mut other = path;
        if i == 654_321 {
            other.radiance[1] = f64::from(1f32.next_up());
        }
        pair.add(address(i), &path, &other);
    }
    assert!(!pair.is_equal());
    assert_eq!((pair.paths - pair.equal, pair.together), (1, 1_000_000));
    assert_eq!(pair.first_unequal, Some(address(654_321)));
}

#[test]
fn a_broken_sample_is_counted_and_worst() {
    let mut pair = Comparison::default();
    let path = |x: f64| Path {
        radiance: [1.0, x, 1.0],
        signature: 0,
    };
    pair.add(address(0), &path(1.0), &path(1.0));
    pair.add(address(1), &path(f64::NAN), &path(1.0));
    pair.add(address(2), &path(f64::INFINITY), &path(f64::INFINITY));
    pair.add(address(3), &path(f64::NAN), &path(-f64::NAN));
    assert_eq!((pair.broken, pair.equal), (3, 3));
    let worst = pair.closeness.worst.expect("a difference");
    assert_eq!((worst.difference, worst.address), (1.0, address(1)));
}

/// Diverged paths with radiances of one distribution, one side's times `factor`.
fn diverged(paths: u64, factor: f64, seed: u64) -> Diverged {
    let mut random = Uniform(seed);
    let mut diverged = Diverged::default();
    for _ in 0..paths {
        diverged.add([(); 3].map(|()| random.radiance() - factor * random.radiance()));
    }
    diverged
}

#[test]
fn a_hundredth_of_the_light_is_a_bias() {
    let paths = 2_000_000;
    assert!(matches!(
        diverged(paths, 1.0, 1).verdict(),
        Verdict::Unbiased(_)
    ));
    assert!(matches!(
        diverged(paths, 1.01, 1).verdict(),
        Verdict::Biased(_)
    ));
    assert!(matches!(
        diverged(paths, 0.99, 1).verdict(),
        Verdict::Biased(_)
    ));
}

/// With few paths and with many, the test cries wolf no more often than it says: α = 1e-3.
#[test]
fn unbiased_paths_are_called_so() {
    for paths in [60, 500] {
        let runs = 4000;
        let biased =
            |seed: &u64| matches!(diverged(paths, 1.0, *seed).verdict(), Verdict::Biased(_));
        let alarms = (1..=runs).filter(biased).count() as u64;
        let chance = Binomial::new(1e-3, runs).expect("a distribution");
        let p = alarms.checked_sub(1).map_or(1.0, |fewer| chance.sf(fewer));
        println!("{paths} paths: {alarms} of {runs} runs biased");
        assert!(p > 1e-4, "{alarms} of {runs}: p = {p:.1e}");
    }
}

#[test]
fn a_handful_is_too_few() {
    assert_eq!(diverged(20, 2.0, 1).verdict(), Verdict::TooFew);
    assert_eq!(Diverged::default().verdict(), Verdict::TooFew);
    // Paths that part and end in the dark on both sides.
    let mut dark = Diverged::default();
    (0..1000).for_each(|_| dark.add([0.0; 3]));
    assert_eq!(
        (dark.verdict(), dark.paths, dark.different),
        (Verdict::TooFew, 1000, 0)
    );
}
