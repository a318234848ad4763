//! Pictures whose errors can be computed by hand.

use vkpt::film::Film;
use vkpt::metrics::{Errors, Pair, Trimmed, trimmed};

use super::pictures::{at, constant, film, mapped};

fn errors(test: &Film, reference: &Film) -> Errors {
    Errors::of(&Pair::new(test, reference).expect("two pictures"))
}

/// f64 sums of a few thousand f32 values: 2000 roundings of 2⁻⁵³, relatively.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs()
}

fn all_close(a: Trimmed, b: f64) -> bool {
    close(a.all, b) && close(a.without_worst, b)
}

#[test]
fn a_picture_equals_itself() {
    let a = film(40, 30, |x, y| [x as f32, y as f32, -0.5]);
    let e = errors(&a, &a);
    for metric in [e.mse, e.rmse, e.rel_mse, e.smape] {
        assert_eq!((metric.all, metric.without_worst), (0.0, 0.0));
    }
    assert_eq!(e.test_mean, e.reference_mean);
    // Means of 0 … 39 and 0 … 29.
    assert_eq!(e.test_mean, [19.5, 14.5, -0.5]);
}

#[test]
fn constant_pictures() {
    // x − r = ½, ¼, 0 in the three channels; all values are exact in f32.
    let e = errors(
        &constant(20, 10, [1.0, 0.5, 2.0]),
        &constant(20, 10, [0.5, 0.25, 2.0]),
    );
    assert!(all_close(e.mse, (0.25 + 0.0625) / 3.0));
    assert!(all_close(e.rmse, ((0.25f64 + 0.0625) / 3.0).sqrt()));
    // ¼/(¼ + .01), 1/16 / (1/16 + .01), 0
    assert!(all_close(e.rel_mse, (0.25 / 0.26 + 0.0625 / 0.0725) / 3.0));
    // ½/(3/2 + .01), ¼/(¾ + .01), 0
    assert!(all_close(e.smape, (0.5 / 1.51 + 0.25 / 0.76) / 3.0));
    assert_eq!(e.test_mean, [1.0, 0.5, 2.0]);
    assert_eq!(e.reference_mean, [0.5, 0.25, 2.0]);
}

#[test]
fn black_pictures_do_not_divide_by_zero() {
    let black = constant(3, 2, [0.0; 3]);
    assert_eq!(errors(&black, &black).smape.all, 0.0);
    let e = errors(&constant(3, 2, [0.5; 3]), &black);
    assert!(all_close(e.rel_mse, 0.25 / 0.01));
    assert!(all_close(e.smape, 0.5 / 0.51));
}

#[test]
fn relative_errors_are_relative_to_the_reference() {
    let (a, b) = (constant(3, 2, [1.0; 3]), constant(3, 2, [3.0; 3]));
    assert!(all_close(errors(&a, &b).rel_mse, 4.0 / 9.01));
    assert!(all_close(errors(&b, &a).rel_mse, 4.0 / 1.01));
    assert_eq!(errors(&a, &b).smape, errors(&b, &a).smape);
}

#[test]
fn one_pixel_off_is_all_of_the_mean_and_none_of_the_trimmed() {
    let grey = constant(20, 10, [0.5; 3]);
    let mut off = grey.clone();
    off.rgb[77] = [0.5, 0.5, 3.5];
    let e = errors(&off, &grey);
    assert!(close(e.mse.all, 9.0 / 600.0));
    assert!(close(e.rmse.all, (9.0f64 / 600.0).sqrt()));
    assert!(close(e.rel_mse.all, 9.0 / 0.26 / 600.0));
    assert!(close(e.smape.all, 3.0 / 4.01 / 600.0));
    for metric in [e.mse, e.rmse, e.rel_mse, e.smape] {
        assert_eq!(metric.without_worst, 0.0);
    }
}

/// The worst are those of the metric itself: a firefly on a lamp is the worst pixel by MSE, not by relMSE.
#[test]
fn each_metric_has_its_own_worst_pixels() {
    let mut reference = constant(10, 10, [1.0; 3]);
    reference.rgb[3] = [100.0; 3];
    let mut test = reference.clone();
    test.rgb[3] = [110.0; 3];
    test.rgb[50] = [3.0; 3];
    let e = errors(&test, &reference);
    assert!(close(e.mse.without_worst, 4.0 / 99.0));
    assert!(close(e.rel_mse.without_worst, 100.0 / 10_000.01 / 99.0));
}

#[test]
fn as_many_pixels_are_left_out_as_documented() {
    // Errors n, n − 1, … 1: without the ⌊n/100⌋ worst, the mean is (kept + 1)/2.
    for (n, kept) in [
        (1, 1),
        (99, 99),
        (100, 99),
        (199, 198),
        (200, 198),
        (1000, 990),
    ] {
        let values: Vec<f64> = (1..=n).rev().map(f64::from).collect();
        let t = trimmed(&values);
        assert_eq!(t.all, f64::from(n + 1) / 2.0);
        assert_eq!(t.without_worst, f64::from(kept + 1) / 2.0);
    }
}

/// ×1.01, a pixel's shift and exchanged channels are seen by every one of the single numbers.
#[test]
fn planted_errors_are_seen() {
    let picture = |dx: u32| {
        film(64, 48, |x, y| {
            let (x, y) = ((x + dx) as f32 / 5.0, y as f32 / 3.0);
            [x.sin() + 1.5, y.cos() + 1.5, (x + y).sin() + 1.5]
        })
    };
    let reference = picture(0);
    let brighter = mapped(&reference, |v| 1.01 * v);
    let swapped = film(64, 48, |x, y| {
        let [r, g, b] = at(&reference, x, y);
        [b, g, r]
    });
    for test in [&brighter, &picture(1), &swapped] {
        let e = errors(test, &reference);
        for metric in [e.mse, e.rmse, e.rel_mse, e.smape] {
            assert!(metric.without_worst > 1e-5 && metric.all > metric.without_worst);
        }
    }
    // ×1.01 is (.01)² r²/(r² + .01) for each value: above that of the darkest (½), below that of r = ∞.
    let e = errors(&brighter, &reference);
    assert!(e.rel_mse.all < 1.000_1e-4 && e.rel_mse.all > 1e-4 * 0.25 / 0.26);
}
