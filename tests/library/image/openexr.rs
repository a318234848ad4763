//! EXRs that the OpenEXR library wrote (data/make.py), against the closed forms that it was given.

use vkpt::image::{Picture, Precision, read};

use super::films::{bits, data};

fn picture(name: &str) -> Picture {
    read(&data(&format!("{name}.exr"))).unwrap_or_else(|error| panic!("{error}"))
}

/// 6×5 pixels; `f` of 1 + x + 16 y.
fn pattern(f: impl Fn(f32) -> [f32; 3]) -> Vec<[f32; 3]> {
    (0..30)
        .map(|i| f((1 + i % 6 + 16 * (i / 6)) as f32))
        .collect()
}

/// Each channel rounded once, in f32.
fn float() -> Vec<[f32; 3]> {
    pattern(|v| [v / 3.0, v / 7.0, v / -1000.0])
}

/// Exact in f16.
fn half() -> Vec<[f32; 3]> {
    pattern(|v| [v / 64.0, v * 4.0, v / -1024.0])
}

#[track_caller]
fn assert_is(name: &str, expected: &[[f32; 3]], precision: Precision) {
    let picture = picture(name);
    assert_eq!([picture.film.width, picture.film.height], [6, 5], "{name}");
    assert_eq!(bits(&picture.film.rgb), bits(expected), "{name}");
    assert_eq!(picture.precision, precision, "{name}");
}

#[test]
fn every_lossless_compression() {
    for compression in ["no", "rle", "zips", "zip", "piz", "pxr24"] {
        let name = format!("half-rgba-{compression}");
        assert_is(&name, &half(), Precision::Half);
        if compression != "pxr24" {
            let name = format!("float-rgb-{compression}");
            assert_is(&name, &float(), Precision::Single);
        }
    }
    // Half too, and one value in 4×4 pixels, which B44 keeps.
    let flat = (0..30).map(|i| {
        let v = (1 + i % 6 / 4 + 2 * (i / 6 / 4)) as f32;
        [v / 4.0, v, v / -8.0]
    });
    let flat: Vec<_> = flat.collect();
    for compression in ["b44", "b44a"] {
        let name = format!("flat-half-{compression}");
        assert_is(&name, &flat, Precision::Lossy);
    }
}

#[test]
fn pxr24_within_its_rounding() {
    let picture = picture("float-rgb-pxr24");
    assert_eq!(picture.precision, Precision::Pxr24);
    let mut worst = 0f64;
    for (stored, exact) in picture.film.rgb.iter().zip(float()) {
        let rounding = picture.precision.rounding(*stored).expect("a bound");
        for channel in 0..3 {
            let error = (f64::from(stored[channel]) - f64::from(exact[channel])).abs();
            worst = worst.max(error / rounding[channel]);
        }
    }
    assert!(0.5 < worst && worst <= 1.0, "{worst}");
}

#[test]
fn lossy_compressions_as_the_library_reads_them() {
    for compression in ["b44", "dwaa", "dwab"] {
        let lossy = picture(&format!("smooth-{compression}"));
        let read = picture(&format!("smooth-{compression}-read"));
        assert_eq!([lossy.film.width, lossy.film.height], [20, 18]);
        assert_eq!(lossy.precision, Precision::Lossy);
        assert_eq!(bits(&lossy.film.rgb), bits(&read.film.rgb), "{compression}");
    }
}

#[test]
fn scan_lines_from_below_and_tiles() {
    assert_is("decreasing", &float(), Precision::Single);
    assert_is("tiled", &float(), Precision::Single);
}

#[test]
fn the_layer_that_is_meant() {
    assert_is("layer-color", &float(), Precision::Single);
    assert_is("layers-and-plain", &float(), Precision::Single);
    assert_is("parts", &float(), Precision::Single);
}

#[test]
fn primaries_that_are_srgb() {
    assert_is("rec709", &float(), Precision::Single);
}

#[test]
fn the_coarsest_channel_counts() {
    let mixed: Vec<_> = half()
        .iter()
        .zip(float())
        .map(|(half, float)| [half[0], float[1], float[2]])
        .collect();
    assert_is("half-and-float", &mixed, Precision::Half);
}

#[test]
fn a_data_window_has_its_place() {
    let picture = picture("windows");
    // Data from 7,−4, display from 5,−3.
    assert_eq!((picture.origin, picture.full), ([2, -1], [20, 10]));
    assert_eq!(bits(&picture.film.rgb), bits(&float()));
}
