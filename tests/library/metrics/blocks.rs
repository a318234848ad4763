//! The block z-test on pictures whose z can be computed by hand.

use vkpt::image::Precision;
use vkpt::metrics::MetricsError;
use vkpt::metrics::blocks::{ALPHA, BlockTest, Estimate, z_test};

use super::estimates::{exact, measured, test};
use super::pictures::{constant, film, mapped};

#[test]
fn blocks_cover_the_picture() {
    let of = |width: u32, height: u32| {
        let grey = constant(width, height, [0.5; 3]);
        test(&exact(&grey), &exact(&grey)).blocks().to_vec()
    };
    let places = |width: u32, height: u32| -> Vec<_> {
        let red = of(width, height).into_iter().filter(|b| b.channel == 0);
        red.map(|b| (b.origin, b.size)).collect()
    };
    assert_eq!(places(1, 24), [([0, 0], [1, 24])]);
    assert_eq!(places(49, 25), [([0, 0], [49, 25])]);
    assert_eq!(
        places(74, 50),
        [
            ([0, 0], [25, 25]),
            ([25, 0], [49, 25]),
            ([0, 25], [25, 25]),
            ([25, 25], [49, 25]),
        ]
    );
    assert_eq!(of(200, 150).len(), 8 * 6 * 3);
}

#[test]
fn z_by_hand() {
    // 50×25 pixels: two blocks of n = 625. Second block, green: means ½ and ¼, errors of a pixel 4 and 3:
    // z = ¼/(√(625·16 + 625·9)/625) = ¼/(5/25) = 1.25, p = 2 Φ(−1.25) = 0.211300 (tables of Φ), but for
    // the rounding of ½ and ¼: of their f32, 2⁻²⁴, and of the arithmetic that led to them, 2⁻²⁰.
    let z = (0.25 - 0.75 * (2f64.powi(-24) + 2f64.powi(-20))) / 0.2;
    let a = film(50, 25, |x, _| [0.5, if x < 25 { 0.25 } else { 0.5 }, 0.5]);
    let b = film(50, 25, |_, _| [0.5, 0.25, 0.5]);
    let (ea, eb) = (constant(50, 25, [4.0; 3]), constant(50, 25, [3.0; 3]));
    let found = test(&measured(&a, &ea), &measured(&b, &eb));
    assert_eq!(found.blocks().len(), 6);
    // 1 − .999^(1/6), by the series α/6 + 5α²/72 + 55α³/1296.
    let level = 1e-3 / 6.0 + 5e-6 / 72.0 + 55e-9 / 1296.0;
    assert!((found.level() - level).abs() < 1e-12);
    let worst = found.worst();
    assert_eq!((worst.origin, worst.size), ([25, 0], [25, 25]));
    assert_eq!((worst.channel, worst.means), (1, [0.5, 0.25]));
    assert!((worst.stderr - 0.2).abs() < 1e-15);
    assert!((worst.z - z).abs() < 1e-12);
    assert!((worst.p - 0.211_300).abs() < 2e-6);
    assert!(found.passes());
    // Five z of 0 and this one: mean z/6, variance (z² − z²/6)/5.
    let [mean, deviation] = found.spread().expect("six z");
    assert!((mean - z / 6.0).abs() < 1e-12);
    assert!((deviation - z / 6f64.sqrt()).abs() < 1e-12);
}

#[test]
fn without_errors_pictures_are_equal_within_rounding() {
    let a = film(30, 30, |x, y| [x as f32, y as f32, 0.0]);
    let next = mapped(&a, f32::next_up);
    let beyond = mapped(&a, |v| v * (1.0 + 32.0 * f32::EPSILON));
    assert!(test(&exact(&a), &exact(&next)).passes());
    let found = test(&exact(&a), &exact(&beyond));
    // Red and green differ; black in blue does not.
    assert_eq!(found.rejected(), 2);
    assert_eq!((found.worst().z, found.worst().p), (f64::NEG_INFINITY, 0.0));
    assert_eq!(found.spread(), None);
    // Errors of 0 are the same as none.
    let zero = constant(30, 30, [0.0; 3]);
    assert_eq!(
        test(&measured(&a, &zero), &exact(&beyond)).blocks(),
        found.blocks()
    );
    // A coarser file explains it.
    let coarse = Estimate {
        precision: Precision::Half,
        ..exact(&beyond)
    };
    assert!(test(&exact(&a), &coarse).passes());
}

#[test]
fn invalid_pictures_are_refused() {
    let good = constant(30, 30, [1.0; 3]);
    let small = constant(29, 30, [1.0; 3]);
    let mut negative = good.clone();
    negative.rgb[31][2] = -1e-3;
    let refusal = |a: &Estimate, b: &Estimate| {
        let found: Result<BlockTest, MetricsError> = z_test(a, b, ALPHA);
        found.expect_err("must be refused").to_string()
    };
    assert_eq!(
        refusal(&exact(&good), &exact(&small)),
        "the first picture has 30×30 pixels, but the second picture 29×30"
    );
    assert_eq!(
        refusal(&exact(&good), &measured(&good, &small)),
        "the second picture has 30×30 pixels, but the second picture's standard errors 29×30"
    );
    assert_eq!(
        refusal(&measured(&good, &negative), &exact(&good)),
        "invalid value -0.001 in the first picture's standard errors at column 1, row 1, channel B"
    );
    let lossy = Estimate {
        precision: Precision::Lossy,
        ..exact(&good)
    };
    assert_eq!(
        refusal(&exact(&good), &lossy),
        "the second picture was compressed with losses that have no bound"
    );
    for alpha in [0.0, 1.0, -1.0, f64::NAN] {
        assert!(z_test(&exact(&good), &exact(&good), alpha).is_err());
    }
}
