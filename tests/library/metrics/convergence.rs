//! The statistics of `vkpt converge` over replicates whose errors are known: noise of variance σ²/n about a picture.

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::film::Film;
use vkpt::metrics::convergence::{
    Figures, Interval, Metric, Reference, Summary, floor, ratio_of_efficiencies, slope,
};
use vkpt::metrics::flip::Viewing;
use vkpt::metrics::{StandardErrors, Trimmed};

use super::pictures::{Random, constant, film, mapped};

/// Of a pixel's single sample.
const SIGMA: f32 = 0.5;
const REPLICATES: usize = 6;
/// A screen so far away that FLIP costs next to nothing.
const VIEWING: Viewing = Viewing {
    exposure: 0.0,
    pixels_per_degree: 2.0,
};

fn truth() -> Film {
    film(12, 10, |x, y| [0.5 + x as f32 / 9.0, 0.8, y as f32 / 5.0])
}

/// A picture of `spp` samples a pixel.
fn rendered(random: &mut Random, truth: &Film, spp: u32) -> Film {
    let sigma = SIGMA / (spp as f32).sqrt();
    random.noisy(truth, &constant(truth.width, truth.height, [sigma; 3]))
}

fn replicates(random: &mut Random, truth: &Film, spp: u32) -> Vec<Film> {
    (0..REPLICATES)
        .map(|_| rendered(random, truth, spp))
        .collect()
}

fn errors(pictures: &[Film], reference: &Reference, metric: Metric) -> Vec<Trimmed> {
    let figures =
        |film: &Film| -> Figures { reference.figures(film, &VIEWING).expect("two pictures") };
    pictures
        .iter()
        .map(|film| *figures(film).of(metric))
        .collect()
}

fn all(errors: &[Trimmed]) -> Vec<f64> {
    errors.iter().map(|e| e.all).collect()
}

fn halves(random: &mut Random, truth: &Film, spp: u32) -> Reference {
    let [a, b] = [0, 1].map(|_| rendered(random, truth, spp));
    Reference::halves(a, b, &VIEWING).expect("two halves")
}

/// Two-sided p of `k` intervals out of `n` containing the truth when each should with 95 %.
fn p_of_coverage(k: u64, n: u64) -> f64 {
    let binomial = Binomial::new(0.95, n).expect("a probability");
    let above = if k == 0 { 1.0 } else { binomial.sf(k - 1) };
    (2.0 * binomial.cdf(k).min(above)).min(1.0)
}

/// Each estimate in many experiments: the share of intervals that contain the truth; and, planted, of the same intervals with
/// the normal's 1.96 instead of Student's 2.571 of 5 degrees of freedom.
fn check_coverage(name: &str, truth: f64, mut experiment: impl FnMut() -> Interval) {
    let experiments = 700;
    let (mut covered, mut narrow) = (0, 0);
    for _ in 0..experiments {
        let interval = experiment();
        covered += u64::from(interval.contains(truth));
        let toward = |end: f64| interval.value + (end - interval.value) * 1.96 / 2.571;
        narrow += u64::from(
            Interval {
                low: toward(interval.low),
                high: toward(interval.high),
                ..interval
            }
            .contains(truth),
        );
    }
    assert!(
        p_of_coverage(covered, experiments) > 1e-4,
        "{name}: {covered}"
    );
    assert!(
        p_of_coverage(narrow, experiments) < 1e-6,
        "planted: {narrow}"
    );
}

#[test]
fn intervals_contain_mse_slope_and_ratio_95_times_in_100() {
    let (truth, mut random) = (truth(), Random(3));
    let exact = Reference::picture(truth.clone(), None).expect("a reference");
    let mse = |random: &mut Random, spp| {
        all(&errors(
            &replicates(random, &truth, spp),
            &exact,
            Metric::Mse,
        ))
    };
    let sigma2 = f64::from(SIGMA * SIGMA);
    check_coverage("MSE", sigma2 / 4.0, || {
        Interval::of_mean(&mse(&mut random, 4)).expect("replicates")
    });
    check_coverage("slope", -1.0, || {
        let (a, b) = (mse(&mut random, 4), mse(&mut random, 8));
        slope((4, &a), (8, &b)).expect("replicates")
    });
    // Four times the samples in twice the seconds, on a machine that drifts.
    check_coverage("ratio", 2.0, || {
        let drift: Vec<f64> = (0..REPLICATES).map(|_| 1.0 + random.uniform()).collect();
        let twice: Vec<f64> = drift.iter().map(|s| 2.0 * s).collect();
        let (a, b) = (mse(&mut random, 4), mse(&mut random, 16));
        ratio_of_efficiencies([&a, &drift], [&b, &twice]).expect("replicates")
    });
}

/// By one noisy picture every error has its noise too; by halves none has.
#[test]
fn halves_have_no_part_in_squared_errors() {
    let (truth, mut random) = (truth(), Random(5));
    let sigma2 = f64::from(SIGMA * SIGMA);
    let mut by_halves = Vec::new();
    let mut by_one = Vec::new();
    let mut own = Vec::new();
    for _ in 0..400 {
        let reference = halves(&mut random, &truth, 8);
        let single = Reference::picture(reference.film().clone(), None).expect("a reference");
        let test = [rendered(&mut random, &truth, 8)];
        by_halves.extend(all(&errors(&test, &reference, Metric::Mse)));
        by_one.extend(all(&errors(&test, &single, Metric::Mse)));
        own.extend(reference.own().of(Metric::Mse));
    }
    let contains = |errors: &[f64], truth: f64| {
        let interval = Interval::of_mean(errors).expect("many");
        interval.contains(truth)
    };
    assert!(contains(&by_halves, sigma2 / 8.0));
    // The mean of two halves of 8 samples has the noise of 16.
    assert!(contains(&own, sigma2 / 16.0));
    assert!(contains(&by_one, sigma2 / 8.0 + sigma2 / 16.0));
    assert!(!contains(&by_one, sigma2 / 8.0), "planted");
}

/// The test's own level is 1e-3: of 500 honest experiments 6 or more have a probability below 1e-4.
#[test]
fn a_floor_is_found_where_there_is_one() {
    let (truth, mut random) = (truth(), Random(7));
    // The reference's noise is less than that of the pictures, as much, and more.
    for (reference_spp, spp) in [(64, 4), (16, 16), (16, 256)] {
        let mut found = 0;
        for _ in 0..500 {
            let reference = halves(&mut random, &truth, reference_spp);
            let pictures = replicates(&mut random, &truth, spp);
            let floor = floor(&pictures, &reference).expect("replicates");
            found += usize::from(floor.is_there());
        }
        assert!(found < 6, "{reference_spp}, {spp}: {found}");
    }
    // Planted: 10 % too bright. E (0.1 r)²/(r² + 0.01), a tenth of the noise at 4 spp.
    let biased = mapped(&truth, |v| 1.1 * v);
    let expected = {
        let of = |&r: &f32| f64::from(0.1 * r).powi(2) / (f64::from(r * r) + 0.01);
        let values = truth.rgb.as_flattened();
        values.iter().map(of).sum::<f64>() / values.len() as f64
    };
    let floors: Vec<f64> = (0..400)
        .map(|_| {
            let reference = halves(&mut random, &truth, 64);
            let pictures = replicates(&mut random, &biased, 16);
            floor(&pictures, &reference).expect("replicates").rel_mse
        })
        .collect();
    let interval = Interval::of_mean(&floors).expect("many");
    // r² + ε of the noisy reference is not that of the truth: 4 % where r is 0.
    assert!(
        interval.low < 1.03 * expected && interval.high > 0.97 * expected,
        "{interval:?} for {expected}"
    );
    let reference = halves(&mut random, &truth, 4096);
    let late = floor(&replicates(&mut random, &biased, 256), &reference).expect("replicates");
    assert!(late.is_there(), "{late:?}");
    assert_eq!(
        floor(&replicates(&mut random, &truth, 4)[..2], &reference),
        None
    );
}

/// The interval of the jackknife, over a reference without noise.
#[test]
fn a_floor_knows_its_own_error() {
    let (truth, mut random) = (truth(), Random(17));
    let reference = Reference::picture(truth.clone(), None).expect("a reference");
    // Above the noise everywhere, or too little would be left of the part that pairs share.
    let biased = mapped(&truth, |v| v + 0.1);
    let expected = {
        let limits = [biased.clone(), biased.clone(), biased.clone()];
        floor(&limits, &reference).expect("replicates").rel_mse
    };
    // Student's t of 5 degrees of freedom, 97.5 %.
    check_coverage("floor", expected, || {
        let pictures = replicates(&mut random, &biased, 1024);
        let floor = floor(&pictures, &reference).expect("replicates");
        let half = 2.571 * floor.standard_error;
        Interval {
            value: floor.rel_mse,
            low: floor.rel_mse - half,
            high: floor.rel_mse + half,
        }
    });
}

/// A floor of 2.5e-3 under noise of σ²/n: the slope is −1 above it and 0 on it.
#[test]
fn a_bias_flattens_the_curve() {
    let (truth, mut random) = (truth(), Random(9));
    let exact = Reference::picture(truth.clone(), None).expect("a reference");
    let biased = mapped(&truth, |v| v + 0.05);
    let at = |random: &mut Random, film: &Film, spp| {
        all(&errors(&replicates(random, film, spp), &exact, Metric::Mse))
    };
    let mut between = |film: &Film, n: u32| {
        let (a, b) = (at(&mut random, film, n), at(&mut random, film, 2 * n));
        slope((n, &a), (2 * n, &b)).expect("replicates")
    };
    assert!(between(&truth, 1 << 14).high < -0.7);
    assert!(between(&biased, 2).high < -0.7);
    assert!(between(&biased, 1 << 14).low > -0.3);
}

/// SMAPE and FLIP fall too, and the summary contains the measurements.
#[test]
fn every_metric_falls_with_the_samples() {
    let (truth, mut random) = (truth(), Random(13));
    let reference = halves(&mut random, &truth, 1 << 16);
    for (metric, name) in Metric::ALL {
        let mut of = |spp| {
            let pictures = replicates(&mut random, &truth, spp);
            Summary::of(&errors(&pictures, &reference, metric)).expect("replicates")
        };
        let (few, many) = (of(4), of(1024));
        assert!(many.mean.high < few.mean.low, "{name}: {few:?} {many:?}");
        assert!(many.median_of_means < few.median_of_means, "{name}");
        assert!(
            few.trimmed < few.mean.value,
            "{name}: 1 of 120 pixels is left out"
        );
        let own = reference.own().of(metric).expect("known");
        assert!(own < many.mean.value, "{name}: {own}");
    }
}

/// The mean of (floor/its standard error)² over references whose noise is all there is, with errors of one degree of freedom
/// that are taken for such of `freedom`.
fn mean_square_of_floors(freedom: f64) -> f64 {
    let (truth, black) = (constant(40, 30, [1.0; 3]), constant(40, 30, [0.0; 3]));
    let mut random = Random(19);
    let mut noisy = |film: &Film, sigma: f64| Film {
        rgb: film
            .rgb
            .iter()
            .map(|p| [p[0] + (sigma * random.normal()) as f32; 3])
            .collect(),
        ..*film
    };
    let trials = 1000;
    let square = |_| {
        let errors = mapped(&noisy(&black, 0.01), f32::abs);
        let errors = StandardErrors {
            film: &errors,
            freedom,
        };
        let reference = Reference::picture(noisy(&truth, 0.01), Some(errors)).expect("a reference");
        let pictures = [(); 3].map(|()| noisy(&truth, 1e-5));
        let floor = floor(&pictures, &reference).expect("three pictures");
        (floor.rel_mse / floor.standard_error).powi(2)
    };
    (0..trials).map(square).sum::<f64>() / f64::from(trials)
}

/// It is 1, with a standard error of √(2/1000).
#[test]
fn the_floor_of_a_reference_allows_for_its_degrees_of_freedom() {
    let off = |freedom| (mean_square_of_floors(freedom) - 1.0).abs() / (2.0f64 / 1000.0).sqrt();
    let (honest, planted) = (off(1.0), off(f64::INFINITY));
    println!("{honest} and {planted} standard errors off");
    assert!(honest < 3.3 && planted > 5.0);
}

#[test]
fn a_reference_of_another_size_or_with_nan_is_refused() {
    let (truth, mut random) = (truth(), Random(17));
    let reference = halves(&mut random, &truth, 4);
    assert!(
        reference
            .figures(&constant(3, 2, [1.0; 3]), &VIEWING)
            .is_err()
    );
    assert!(Reference::halves(truth.clone(), constant(3, 2, [1.0; 3]), &VIEWING).is_err());
    assert!(Reference::picture(mapped(&truth, |_| f32::NAN), None).is_err());
    let negative = mapped(&truth, |_| -1.0);
    assert!(Reference::picture(truth.clone(), Some(StandardErrors::exact(&negative))).is_err());
}
