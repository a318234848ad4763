//! The heat map's colours against the published table of magma.

use vkpt::image::srgb;
use vkpt::metrics::{HEATMAP_RANGE, Pair, heatmap, heatmap_scale};

use super::pictures::{constant, film};

/// The PNG's codes of the map for a pixel of this relMSE.
fn code(error: f64) -> [u8; 3] {
    // The reference is black: relMSE is x²/0.01 in each channel.
    let test = constant(2, 1, [(0.01 * error).sqrt() as f32; 3]);
    let black = constant(2, 1, [0.0; 3]);
    let map = heatmap(&Pair::new(&test, &black).expect("two pictures"));
    assert_eq!((map.width, map.height, map.rgb[0]), (2, 1, map.rgb[1]));
    map.rgb[0].map(|v| srgb::quantise(f64::from(v)))
}

#[test]
fn the_scale_is_fixed() {
    assert_eq!(HEATMAP_RANGE, [1e-6, 1.0]);
    // First, middle (of 256: number 128) and last colour of Matplotlib's magma, as 8-bit codes; the middle one
    // by interpolation, give or take a code.
    let (first, last) = ([0, 0, 4], [252, 253, 191]);
    for error in [0.0, 1e-9, 1e-6] {
        assert_eq!(code(error), first);
    }
    for error in [1.000_001, 1e9] {
        assert_eq!(code(error), last);
    }
    let middle = code(1e-3);
    for (ours, theirs) in middle.into_iter().zip([183, 55, 121]) {
        assert!(ours.abs_diff(theirs) <= 2, "{middle:?}");
    }
}

#[test]
fn a_larger_error_is_brighter() {
    let test = film(61, 1, |x, _| [10f32.powf(x as f32 / 20.0 - 4.0); 3]);
    let map = heatmap(&Pair::new(&test, &constant(61, 1, [0.0; 3])).expect("two pictures"));
    let brightness: Vec<f32> = map.rgb.iter().map(|rgb| rgb.iter().sum()).collect();
    assert!(brightness.is_sorted() && brightness[0] < brightness[60]);
}

#[test]
fn the_scale_has_the_colours_of_its_figures() {
    let scale = heatmap_scale(7);
    assert_eq!((scale.width, scale.height), (7, 1));
    for (i, rgb) in scale.rgb.iter().enumerate() {
        let shown = rgb.map(|v| srgb::quantise(f64::from(v)));
        // 1e-6, 1e-5 … 1; the map's own error is rounded in f32.
        for (a, b) in shown.into_iter().zip(code(10f64.powi(i as i32 - 6))) {
            assert!(a.abs_diff(b) <= 1, "{i}");
        }
    }
}
