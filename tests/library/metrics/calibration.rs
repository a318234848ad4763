//! How often the block z-test rejects pictures that agree, and what its deviation says about the given errors.

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::film::Film;
use vkpt::image::Precision;
use vkpt::metrics::StandardErrors;
use vkpt::metrics::blocks::{BlockTest, Estimate, Stderr, z_test};

use super::pictures::{Random, constant, film, mapped};

fn test(a: &Film, b: &Film, stderr: &Film, alpha: f64) -> BlockTest {
    let [a, b] = [a, b].map(|mean| Estimate {
        mean,
        stderr: Stderr::PerPixel(StandardErrors::exact(stderr)),
        precision: Precision::Single,
    });
    z_test(&a, &b, alpha).expect("two pictures")
}

/// Two-sided p of k successes in n trials of probability p.
fn p_of_count(k: u64, n: u64, p: f64) -> f64 {
    let binomial = Binomial::new(p, n).expect("a probability");
    let below = binomial.cdf(k);
    let above = if k == 0 { 1.0 } else { binomial.sf(k - 1) };
    (2.0 * below.min(above)).min(1.0)
}

/// Means and errors that differ from pixel to pixel, in blocks of 625 to 1225 pixels.
fn null(width: u32, height: u32) -> [Film; 2] {
    let mean = film(width, height, |x, y| [x as f32 / 10.0, y as f32 / 7.0, 1.0]);
    let stderr = film(width, height, |x, y| {
        [0.1, 0.2 + (x % 3) as f32, 0.05 * (1 + y % 2) as f32]
    });
    [mean, stderr]
}

/// The comparison's own level is 1e-4, shared by two tests.
#[test]
fn under_normal_noise_it_rejects_as_often_as_it_says() {
    let [mean, stderr] = null(60, 50);
    let mut random = Random(11);
    let pictures = 600u64;
    let mut rejected = 0;
    let mut z = Vec::new();
    for _ in 0..pictures {
        let [a, b] = [0, 1].map(|_| random.noisy(&mean, &stderr));
        let found = test(&a, &b, &stderr, 0.05);
        rejected += u64::from(!found.passes());
        z.extend(found.blocks().iter().map(|b| b.z));
    }
    assert!(p_of_count(rejected, pictures, 0.05) > 0.5e-4, "{rejected}");
    // The mean square of n z has the mean 1 and the standard deviation √(2/n): within 4.06 of those at 0.5e-4.
    let n = z.len() as f64;
    let square = z.iter().map(|z| z * z).sum::<f64>() / n;
    assert!((square - 1.0).abs() < 4.06 * (2.0 / n).sqrt(), "{square}");
}

/// Of 4000 pairs of pictures of `size`, how many are rejected at 5 % by errors of one degree of freedom a pixel, whose
/// blocks take `freedom` for that of each.
fn rejected_by_estimates([width, height]: [u32; 2], freedom: f64) -> u64 {
    let mean = constant(width, height, [1.0; 3]);
    let exact = film(width, height, |x, y| {
        [0.1, 0.1 + 0.1 * (x % 2) as f32, 0.1 * (1 + y % 3) as f32]
    });
    let black = constant(width, height, [0.0; 3]);
    let mut random = Random(15);
    let rejects = |_: &u32| {
        // A normal number's square times the variance is an unbiased estimate of it.
        let [a, b] = [0, 1].map(|_| random.noisy(&mean, &exact));
        let [stderr_a, stderr_b] = [0, 1].map(|_| mapped(&random.noisy(&black, &exact), f32::abs));
        let [a, b] = [(&a, &stderr_a), (&b, &stderr_b)].map(|(mean, film)| Estimate {
            mean,
            stderr: Stderr::PerPixel(StandardErrors { film, freedom }),
            precision: Precision::Single,
        });
        !z_test(&a, &b, 0.05).expect("two pictures").passes()
    };
    (0..4000).filter(rejects).count() as u64
}

/// A block of 20 pixels has up to 40 degrees of freedom; taken for infinitely many, it rejects too often.
#[test]
fn errors_of_one_degree_of_freedom_reject_as_often_as_the_test_says() {
    let honest = rejected_by_estimates([5, 4], 1.0);
    let planted = rejected_by_estimates([5, 4], f64::INFINITY);
    println!("{honest} and {planted} of 4000");
    assert!(p_of_count(honest, 4000, 0.05) > 1e-3, "{honest}");
    assert!(p_of_count(planted, 4000, 0.05) < 1e-3, "{planted}");
}

/// Errors given 20 % too small or too large: the deviation of z is 1/0.8 or 1/1.2 instead of 1. Of 1200×900
/// pixels' 5184 z it is known to 1/√(2·5184) = 1 %.
#[test]
fn errors_that_lie_show_in_the_deviation() {
    let [mean, stderr] = null(1200, 900);
    let mut random = Random(12);
    let [a, b] = [0, 1].map(|_| random.noisy(&mean, &stderr));
    for (factor, deviation) in [(1.0f32, 1.0), (0.8, 1.25), (1.2, 1.0 / 1.2)] {
        let claimed = mapped(&stderr, |v| factor * v);
        let [z_mean, z_deviation] = test(&a, &b, &claimed, 1e-3).spread().expect("many z");
        assert!(
            (z_deviation / deviation - 1.0).abs() < 0.05,
            "{factor}: {z_deviation}"
        );
        // 5 standard errors of a mean of 5184.
        assert!(z_mean.abs() < 5.0 * deviation / 72.0, "{factor}: {z_mean}");
    }
}

/// The test relies on a block's mean being normal. Fireflies (a pixel is 2500 with probability 1/2500, else 0)
/// come 0.25 to a block: even with errors that are right, their count is Poisson's, and three in one block, which
/// is nothing rare, are 5.5 standard errors. Where they are a fifth of the pixels the level is kept.
#[test]
fn rare_fireflies_are_no_normal_noise() {
    // 100 pictures, α = 1e-3: 4 rejections have the probability 4e-6 by chance.
    assert!(rejected(2500, 13) >= 4);
    assert!(rejected(5, 14) < 4);
}

/// How many of 100 pictures, whose pixels are `rarity` with probability 1/`rarity` and else 0, the test rejects.
fn rejected(rarity: u32, seed: u64) -> usize {
    let mut random = Random(seed);
    // Mean 1, variance rarity − 1.
    let stderr = constant(100, 100, [((rarity - 1) as f32).sqrt(); 3]);
    let mean = constant(100, 100, [1.0; 3]);
    let mut value = || {
        let lit = random.uniform() * f64::from(rarity) < 1.0;
        if lit { rarity as f32 } else { 0.0 }
    };
    let mut picture = || Film {
        rgb: (0..10_000).map(|_| [value(), value(), value()]).collect(),
        ..mean
    };
    let passes = |picture: &Film| {
        let [a, b] = [
            (picture, Stderr::PerPixel(StandardErrors::exact(&stderr))),
            (&mean, Stderr::Exact),
        ]
        .map(|(mean, stderr)| Estimate {
            mean,
            stderr,
            precision: Precision::Single,
        });
        z_test(&a, &b, 1e-3).expect("two pictures").passes()
    };
    (0..100).filter(|_| !passes(&picture())).count()
}
