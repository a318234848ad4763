//! Pictures that cannot be compared, and the messages about them.

use vkpt::film::Film;
use vkpt::metrics::Pair;

use super::pictures::constant;

fn refusal(test: &Film, reference: &Film) -> String {
    Pair::new(test, reference)
        .expect_err("must be refused")
        .to_string()
}

#[test]
fn sizes_that_differ() {
    let (a, b) = (constant(4, 3, [1.0; 3]), constant(3, 4, [1.0; 3]));
    assert_eq!(
        refusal(&a, &b),
        "the test picture has 4×3 pixels, but the reference 3×4"
    );
}

#[test]
fn films_that_are_none() {
    let empty = constant(0, 3, [1.0; 3]);
    assert_eq!(refusal(&empty, &empty), "the test picture has no pixels");
    let good = constant(4, 3, [1.0; 3]);
    let mut short = good.clone();
    short.rgb.pop();
    assert_eq!(
        refusal(&good, &short),
        "the reference is 4×3 pixels, but its film has 11"
    );
}

#[test]
fn values_that_are_not_finite() {
    let good = constant(4, 3, [1.0; 3]);
    for (value, text) in [(f32::NAN, "NaN"), (f32::NEG_INFINITY, "-inf")] {
        let mut bad = good.clone();
        bad.rgb[6][1] = value;
        assert_eq!(
            refusal(&bad, &good),
            format!("invalid value {text} in the test picture at column 2, row 1, channel G")
        );
        assert!(Pair::new(&good, &bad).is_err());
    }
}
