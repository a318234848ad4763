//! vkpt reads its own files again: an EXR to the bit, an HDR and a PNG to their rounding.

use vkpt::film::Film;
use vkpt::image::{Format, Precision, decode, read};

use super::films::{bits, encoded, film};
use crate::common::data::data;

#[test]
fn an_exr_keeps_bits_and_place() {
    let film = film();
    let picture = decode(&encoded(&film, Format::Exr, 0.0)).expect("a picture");
    assert_eq!(bits(&picture.film.rgb), bits(&film.rgb));
    assert_eq!([picture.film.width, picture.film.height], [7, 5]);
    assert_eq!((picture.origin, picture.full), ([3, 2], [20, 10]));
    assert_eq!(picture.precision, Precision::Single);
}

/// 64 × 64 pixels with channels from 1e-31 to 1e31, as near or far from one another as a hash has it.
fn wide_film() -> Film {
    let value = |i: u32| {
        let hash = i.wrapping_mul(0x9e37_79b9) ^ (i.wrapping_mul(0x85eb_ca6b) >> 7);
        let exponent = f64::from(hash >> 16) / 65536.0 * 206.0 - 103.0;
        exponent.exp2() as f32
    };
    let rgb = (0..64 * 64).map(|i| [value(3 * i), value(3 * i + 1), value(3 * i) * 0.3]);
    Film {
        width: 64,
        height: 64,
        rgb: rgb.collect(),
    }
}

#[test]
fn an_hdr_is_half_a_step_off() {
    let film = wide_film();
    let picture = decode(&encoded(&film, Format::Hdr, 0.0)).expect("a picture");
    // No window: the film is the picture.
    assert_eq!((picture.origin, picture.full), ([0, 0], [64, 64]));
    assert_eq!(picture.precision, Precision::Rgbe);
    let mut worst = 0f64;
    for (written, read) in film.rgb.iter().zip(&picture.film.rgb) {
        let largest = f64::from(written.iter().copied().fold(0.0, f32::max));
        for (w, r) in written.iter().zip(read) {
            worst = worst.max((f64::from(*w) - f64::from(*r)).abs() / largest);
        }
    }
    // Half of 1/128, reached where the largest m is 128; truncation would come near the whole.
    assert!(worst <= 1.0 / 256.0, "{worst}");
    assert!(worst > 0.9 / 256.0, "{worst}");
    // And a film that was read is written again unchanged.
    let again = decode(&encoded(&picture.film, Format::Hdr, 0.0)).expect("a picture");
    assert_eq!(bits(&again.film.rgb), bits(&picture.film.rgb));
}

#[test]
fn an_hdr_keeps_every_pixel_of_the_format() {
    // Each exponent with each largest m; the other two run through all smaller ones.
    let pixels = (23..=255).flat_map(|e| {
        let at = move |m: i32| (f64::from(m) * f64::from(e - 136).exp2()) as f32;
        (128..=255).map(move |m| [at((7 * m + e) % m), at(m), at((e * m) % m)])
    });
    let film = Film {
        width: 128,
        height: 233,
        rgb: pixels.collect(),
    };
    let picture = decode(&encoded(&film, Format::Hdr, 0.0)).expect("a picture");
    assert_eq!(bits(&picture.film.rgb), bits(&film.rgb));
}

#[test]
fn an_hdr_clamps_values_beyond_its_range() {
    let film = Film {
        width: 3,
        height: 1,
        rgb: vec![[f32::MAX, 0.0, 1e38], [1e-33, 1e-45, 0.0], [-1.0, 0.5, 0.0]],
    };
    let picture = decode(&encoded(&film, Format::Hdr, 0.0)).expect("a picture");
    // The largest is 255·2^119 (e = 255); next to it a step is 2^119, of which 1e38 has 150.46.
    let step = 119f64.exp2();
    assert_eq!(
        picture.film.rgb,
        [
            [(255.0 * step) as f32, 0.0, (150.0 * step) as f32],
            [0.0; 3],
            [0.0, 0.5, 0.0]
        ]
    );
}

#[test]
fn a_png_comes_back_as_its_codes() {
    let film = wide_film();
    let first = encoded(&film, Format::Png, 0.0);
    let picture = decode(&first).expect("a picture");
    assert_eq!(picture.precision, Precision::Srgb { bits: 8 });
    assert_eq!(encoded(&picture.film, Format::Png, 0.0), first);
}

#[test]
fn the_format_of_a_file_is_that_of_its_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    for format in [Format::Png, Format::Hdr, Format::Exr] {
        let bytes = encoded(&film(), format, 0.0);
        let path = folder.path().join("picture.txt");
        std::fs::write(&path, &bytes).expect("written");
        assert_eq!(read(&path).expect("read"), decode(&bytes).expect("decoded"));
    }
}

#[test]
fn the_oracle_is_read() {
    let picture = read(&data("oracle/cornell-beer.exr")).expect("a picture");
    assert_eq!(picture.full, [200, 150]);
    let n = picture.film.rgb.len() as f64;
    // The means that its README states, to their five digits.
    for (channel, mean) in [0.31629, 0.25786, 0.20918].into_iter().enumerate() {
        let values = picture.film.rgb.iter().map(|p| f64::from(p[channel]));
        let read = values.sum::<f64>() / n;
        assert!((read - mean).abs() <= 0.5e-5, "{channel}: {read} {mean}");
    }
}
