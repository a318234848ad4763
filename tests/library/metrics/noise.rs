//! The error that a picture estimates of itself, against its actual error: films of known truth and distribution.

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::film::Film;
use vkpt::metrics::noise::{Culprits, RelMse, rel_mse};
use vkpt::metrics::{Errors, Pair};

use super::pictures::{Random, constant, film, mapped};

// ---- closed forms

/// A constant picture is its own guide: where h is so small that nothing is put right, relMSE = h²/(r² + 0.01).
#[test]
fn of_a_constant_picture_it_is_the_closed_form() {
    for r in [0.0f32, 0.05, 1.0, 40.0] {
        let h = 1e-4 * r.max(0.1);
        let estimate = of(&constant(9, 7, [r; 3]), &constant(9, 7, [h; 3])).estimate;
        let (r, h) = (f64::from(r), f64::from(h));
        let exact = h * h / (r * r + 0.01);
        assert!(
            (estimate / exact - 1.0).abs() < 1e-5,
            "{r}: {estimate:e}, {exact:e}"
        );
    }
}

/// One pixel of sixty-three is a firefly of height f: it counts with the value to which its neighbours converge.
#[test]
fn a_firefly_counts_with_the_weight_of_its_neighbours() {
    let at = |x, y, f, rest| if (x, y) == (4, 3) { [f; 3] } else { [rest; 3] };
    let found = of(
        &film(9, 7, |x, y| at(x, y, 1e4, 0.5)),
        &film(9, 7, |x, y| at(x, y, 1e4, 0.0)),
    );
    let exact = 1e8 / (0.25 + 0.01) / 63.0;
    assert!((found.estimate / exact - 1.0).abs() < 1e-6, "{found:?}");
    // One pixel gives no estimate, only its own place.
    let it = Culprits {
        half: 1,
        worst: [4, 3],
    };
    assert_eq!(found.interval, Err(it));
}

/// Fireflies of 4, 3, 2 and 1 parts of the error, each alone among its neighbours: the first two make more than half.
#[test]
fn few_pixels_that_make_the_error_are_named() {
    let parts = [
        ([2, 2], 2.0f32),
        ([12, 2], 4.0),
        ([2, 12], 1.0),
        ([12, 12], 3.0),
    ];
    let half = film(15, 15, |x, y| {
        let here = parts.iter().find(|(at, _)| *at == [x, y]);
        [here.map_or(0.0, |(_, part)| part.sqrt()); 3]
    });
    let culprits = |mean: &Film| of(mean, &half).interval.expect_err("four pixels");
    let flat = constant(15, 15, [0.5; 3]);
    let it = Culprits {
        half: 2,
        worst: [12, 2],
    };
    assert_eq!(culprits(&flat), it);
    // Where the surroundings are bright, an error counts less.
    let bright = film(15, 15, |_, y| [if y < 8 { 50.0 } else { 0.5 }; 3]);
    let it = Culprits {
        half: 1,
        worst: [12, 12],
    };
    assert_eq!(culprits(&bright), it);
}

#[test]
fn no_noise_is_no_error() {
    let picture = film(5, 4, |x, y| [x as f32, y as f32, 0.0]);
    let found = of(&picture, &constant(5, 4, [0.0; 3]));
    assert_eq!((found.estimate, found.interval), (0.0, Ok([0.0, 0.0])));
}

#[test]
fn pictures_of_any_size_are_taken() {
    for (width, height) in [(1, 1), (2, 1), (1, 7), (3, 3), (40, 2)] {
        let found = of(
            &constant(width, height, [1.0; 3]),
            &constant(width, height, [0.1; 3]),
        );
        assert!(
            (found.estimate / (0.01 / 1.01) - 1.0).abs() < 0.1,
            "{width}×{height}: {found:?}"
        );
    }
}

#[test]
fn invalid_pictures_are_refused() {
    let good = constant(3, 2, [1.0; 3]);
    for (mean, half, message) in [
        (
            &good,
            &constant(2, 3, [0.0; 3]),
            "3×2 pixels, but the half difference 2×3",
        ),
        (
            &constant(3, 2, [f32::NAN; 3]),
            &good,
            "invalid value NaN in the picture",
        ),
        (
            &good,
            &constant(3, 2, [f32::INFINITY; 3]),
            "invalid value inf in the half difference",
        ),
    ] {
        let error = rel_mse(mean, half).expect_err("no picture").to_string();
        assert!(error.contains(message), "{error}");
    }
}

fn of(mean: &Film, half_difference: &Film) -> RelMse {
    rel_mse(mean, half_difference).expect("two films")
}

// ---- coverage

/// A distribution of samples.
struct Row {
    name: &'static str,
    truth: Film,
    /// The mean of one of two groups in a pixel that converges to `r`, given the channels' common random numbers.
    group: fn(&mut Random, r: [f32; 3]) -> [f64; 3],
    /// Whether intervals are to be as short as they can be: of normal noise, the same in all channels.
    exact: bool,
    /// Whether an interval is expected; with fireflies there may be none.
    has_interval: bool,
    /// Factors by which the noise may be reported too small or too large, and be noticed.
    planted: [f32; 2],
}

fn rows() -> [Row; 5] {
    let flat = constant(48, 48, [0.5; 3]);
    // Sky, floor, a dark block and a lamp: edges between 0.02 and 8.
    let edges = film(48, 48, |x, y| match (x, y) {
        (0..6, 0..6) => [8.0, 7.0, 5.0],
        (20..34, 24..40) => [0.02, 0.03, 0.02],
        (_, 0..20) => [0.6, 0.7, 0.9],
        _ => [0.1 + x as f32 / 80.0, 0.3, 0.2],
    });
    [
        Row {
            name: "normal noise of 3 %",
            truth: flat.clone(),
            group: |random, r| {
                let z = random.normal();
                r.map(|r| f64::from(r) * (1.0 + 0.03 * z))
            },
            exact: true,
            has_interval: true,
            planted: [0.85, 1.15],
        },
        Row {
            name: "normal noise of 20 %, edges, channels apart",
            truth: edges.clone(),
            group: |random, r| r.map(|r| f64::from(r) * (1.0 + 0.2 * random.normal())),
            exact: false,
            has_interval: true,
            planted: [0.85, 1.15],
        },
        Row {
            name: "16 exponential samples, edges",
            truth: edges,
            group: |random, r| {
                let sum: f64 = (0..16).map(|_| -(1.0 - random.uniform()).ln()).sum();
                r.map(|r| f64::from(r) * sum / 16.0)
            },
            exact: false,
            has_interval: true,
            planted: [0.85, 1.15],
        },
        Row {
            name: "one sample in four is lit",
            truth: flat.clone(),
            group: |random, r| {
                let lit = (0..32).filter(|_| random.uniform() < 0.25).count();
                r.map(|r| f64::from(r) * lit as f64 / 8.0)
            },
            exact: false,
            has_interval: true,
            planted: [0.85, 1.15],
        },
        Row {
            name: "fireflies in one group of fifty",
            truth: flat,
            group: |random, r| {
                let z = random.normal();
                let firefly = if random.uniform() < 0.02 { 15.0 } else { 0.0 };
                r.map(|r| f64::from(r) * (0.7 + 0.05 * z + firefly))
            },
            exact: false,
            has_interval: false,
            planted: [0.7, 1.4],
        },
    ]
}

/// A picture of a row's distribution, and half the difference of its groups.
fn halves(row: &Row, random: &mut Random) -> [Film; 2] {
    let pixel = |r: &[f32; 3]| {
        let [a, b] = [0, 1].map(|_| (row.group)(random, *r));
        let with = |sign: f64| [0, 1, 2].map(|c| (0.5 * (a[c] + sign * b[c])) as f32);
        [with(1.0), with(-1.0)]
    };
    let pixels: Vec<_> = row.truth.rgb.iter().map(pixel).collect();
    [0, 1].map(|i| Film {
        rgb: pixels.iter().map(|halves| halves[i]).collect(),
        ..row.truth
    })
}

/// How many intervals there are of `pictures` pictures, and how many of those miss the truth; `scale` plants errors.
fn misses(row: &Row, pictures: u64, scale: f32) -> [u64; 2] {
    let mut random = Random(21);
    let (mut given, mut missed, mut ratio) = (0, 0, 0.0);
    for _ in 0..pictures {
        let [mean, half] = halves(row, &mut random);
        let pair = Pair::new(&mean, &row.truth).expect("two pictures");
        let truth = Errors::of(&pair).rel_mse.all;
        let found = of(&mean, &mapped(&half, |h| scale * h));
        ratio += found.estimate / truth / pictures as f64;
        if let Ok([low, high]) = found.interval {
            given += 1;
            missed += u64::from(truth < low || truth > high);
        }
    }
    println!(
        "{}, × {scale}: {missed} of {given} miss, estimate/truth {ratio:.4}",
        row.name
    );
    [given, missed]
}

/// P(K ≥ k) and P(K ≤ k) of K misses in n at 5 % each.
fn tails([n, k]: [u64; 2]) -> [f64; 2] {
    let binomial = Binomial::new(0.05, n).expect("a probability");
    [
        if k == 0 { 1.0 } else { binomial.sf(k - 1) },
        binomial.cdf(k),
    ]
}

/// α = 1e-3 in all: six one-sided tests and ten planted errors (Bonferroni).
const LEVEL: f64 = 1e-3 / 16.0;

fn check(pictures: u64) {
    for row in rows() {
        let count = misses(&row, pictures, 1.0);
        let least = if row.has_interval { 9 } else { 3 };
        assert!(count[0] > pictures * least / 10, "{}: {count:?}", row.name);
        let [too_many, too_few] = tails(count);
        assert!(too_many > LEVEL, "{}: {count:?}", row.name);
        assert!(!row.exact || too_few > LEVEL, "{}: {count:?}", row.name);
        for planted in row.planted {
            let count = misses(&row, pictures, planted);
            assert!(
                tails(count)[0] < LEVEL,
                "{}, × {planted}: {count:?}",
                row.name
            );
        }
    }
}

#[test]
fn intervals_contain_the_truth_as_often_as_they_claim() {
    check(120);
}

#[test]
#[ignore = "half a minute"]
fn intervals_contain_the_truth_in_thousands_of_pictures() {
    check(4000);
}
