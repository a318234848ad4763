//! The bound of a denoised picture's error, where the truth is known.

use statrs::distribution::{Binomial, DiscreteCDF};
use vkpt::film::Film;
use vkpt::metrics::denoised::bound;

use super::pictures::{Random, constant, film, mapped};
use crate::common::stats::p_of_mean;

const TRIALS: usize = 400;
const ALPHA: f64 = 1e-3;

fn truth() -> Film {
    film(64, 48, |x, y| [0.2 + x as f32 / 64.0, 0.5, y as f32 / 12.0])
}

/// A picture that is off as denoised ones are: smoothly, and without noise.
fn denoised(truth: &Film) -> Film {
    film(truth.width, truth.height, |x, y| {
        let off = 0.03 * (x as f32 / 9.0).sin() * (y as f32 / 7.0).cos();
        truth.rgb[(y * truth.width + x) as usize].map(|r| r + off)
    })
}

/// Mean of (d − r)²/(d² + 0.01), by its definition.
fn error(d: &Film, r: &Film) -> f64 {
    let values = d.rgb.as_flattened().iter().zip(r.rgb.as_flattened());
    let terms = values.map(|(&d, &r)| {
        let (d, r) = (f64::from(d), f64::from(r));
        (d - r) * (d - r) / (d * d + 0.01)
    });
    terms.sum::<f64>() / d.rgb.as_flattened().len() as f64
}

/// Errors of the estimates, and how many bounds contain the truth, where `pictures` makes the denoised picture and the two
/// quarters.
fn trials(mut pictures: impl FnMut(&mut Random) -> [Film; 3]) -> (Vec<f64>, u64) {
    let truth = truth();
    let mut random = Random(19);
    let (mut errors, mut covered) = (Vec::new(), 0);
    for _ in 0..TRIALS {
        let [d, a, b] = pictures(&mut random);
        let found = bound(&d, [&a, &b]).expect("pictures");
        let right = error(&d, &truth);
        errors.push(found.estimate - right);
        covered += u64::from(found.upper >= right);
    }
    (errors, covered)
}

/// The probability that so few of the trials are within a bound that covers 95 in a hundred.
fn p_of_coverage(covered: u64) -> f64 {
    let law = Binomial::new(0.95, TRIALS as u64).expect("a law");
    law.cdf(covered)
}

#[test]
fn the_estimate_is_unbiased_and_the_bound_covers_the_error() {
    let (truth, spread) = (truth(), constant(64, 48, [0.3, 0.2, 0.5]));
    let (errors, covered) = trials(|random| {
        let [a, b] = [(); 2].map(|()| random.noisy(&truth, &spread));
        [denoised(&truth), a, b]
    });
    let p = p_of_mean(&errors, 0.0, 0.0);
    assert!(p > ALPHA, "p = {p:.1e}");
    assert!(p_of_coverage(covered) > ALPHA, "{covered} of {TRIALS}");
}

/// Quarters that share their noise look too bad, a denoised picture that has some of theirs too good.
#[test]
fn pictures_that_are_not_independent_are_noticed() {
    let (truth, spread) = (truth(), constant(64, 48, [0.3; 3]));
    let (errors, _) = trials(|random| {
        let a = random.noisy(&truth, &spread);
        [denoised(&truth), a.clone(), a]
    });
    assert!(p_of_mean(&errors, 0.0, 0.0) < ALPHA);
    let (errors, covered) = trials(|random| {
        let [a, b] = [(); 2].map(|()| random.noisy(&truth, &spread));
        // A third of each quarter's noise.
        let d = film(64, 48, |x, y| {
            let i = (y * 64 + x) as usize;
            [0, 1, 2].map(|c| (truth.rgb[i][c] + a.rgb[i][c] + b.rgb[i][c]) / 3.0)
        });
        [d, a, b]
    });
    assert!(p_of_mean(&errors, 0.0, 0.0) < ALPHA);
    assert!(p_of_coverage(covered) < ALPHA, "{covered} of {TRIALS}");
}

#[test]
fn a_perfect_picture_has_no_error_and_pictures_of_other_sizes_no_bound() {
    let truth = truth();
    let found = bound(&truth, [&truth, &truth]).expect("pictures");
    assert_eq!((found.estimate, found.upper), (0.0, 0.0));
    let tiny = constant(16, 16, [1.0; 3]);
    let other = constant(16, 17, [1.0; 3]);
    assert!(bound(&tiny, [&tiny, &other]).is_err());
    assert!(bound(&mapped(&tiny, |_| f32::NAN), [&tiny, &tiny]).is_err());
}
