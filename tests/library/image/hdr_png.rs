//! HDRs and PNGs that OpenCV and Pillow wrote (data/make.py), against the closed forms that they were given.

use vkpt::image::{Picture, Precision, decode, read};

use super::films::{bits, data};

fn picture(name: &str) -> Picture {
    read(&data(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// `f` of column and row.
fn pixels(width: u32, f: impl Fn(u32, u32) -> [f32; 3]) -> Vec<[f32; 3]> {
    (0..5 * width).map(|i| f(i % width, i / width)).collect()
}

#[test]
fn hdr_with_run_lengths_and_without() {
    for (name, width) in [("wide.hdr", 12), ("narrow.hdr", 6)] {
        let picture = picture(name);
        // Steps of 1 below 256: all of them exact.
        let expected = pixels(width, |x, y| {
            let v = (1 + x + 16 * y) as f32;
            [v, 128.0, 2.0 * v]
        });
        assert_eq!(bits(&picture.film.rgb), bits(&expected), "{name}");
        assert_eq!(picture.full, [width, 5]);
        assert_eq!(picture.precision, Precision::Rgbe);
    }
}

/// The HDR with other lines in its header.
fn with_header(first: &str, lines: &str) -> Vec<u8> {
    let file = std::fs::read(data("narrow.hdr")).expect("a file");
    let end_of_line = file.iter().position(|&b| b == b'\n').expect("a line");
    [
        first.as_bytes(),
        b"\n",
        lines.as_bytes(),
        &file[end_of_line + 1..],
    ]
    .concat()
}

#[test]
fn the_exposure_of_a_header_is_undone() {
    let plain = picture("narrow.hdr").film;
    let decoded = |first, lines| decode(&with_header(first, lines)).expect("a picture").film;
    // Radiance itself writes commands without a `=`, and two exposures multiply.
    let exposed = decoded("#?RADIANCE", "rpict -vp 0 0 1\nEXPOSURE=4\nEXPOSURE= 0.5\n");
    let doubled = exposed.rgb.as_flattened().iter().map(|v| 2.0 * v);
    assert!(doubled.eq(plain.rgb.as_flattened().iter().copied()));
    let srgb = "COLORCORR=1 1 1\nPRIMARIES=.64 .33 .3 .6 .15 .06 .3127 .329\n";
    assert_eq!(decoded("#?RADIANCE", srgb), plain);
    assert_eq!(decoded("#?RGBE", ""), plain);
}

/// IEC 61966-2-1 in f64, from its definition.
fn linear(code: f64) -> f32 {
    let linear = match code {
        c if c <= 0.04045 => c / 12.92,
        c => ((c + 0.055) / 1.055).powf(2.4),
    };
    linear as f32
}

#[track_caller]
fn assert_codes(name: &str, bits_a_code: u8, codes: impl Fn(u32, u32) -> [u32; 3]) {
    let picture = picture(name);
    assert_eq!(picture.full, [6, 5], "{name}");
    assert_eq!(
        picture.precision,
        Precision::Srgb { bits: bits_a_code },
        "{name}"
    );
    let most = f64::from(2u32.pow(bits_a_code.into()) - 1);
    let expected = pixels(6, |x, y| codes(x, y).map(|c| linear(f64::from(c) / most)));
    // One f64 operation in another order may round otherwise, and so may the f32.
    for (read, expected) in picture
        .film
        .rgb
        .as_flattened()
        .iter()
        .zip(expected.as_flattened())
    {
        assert!(
            (read - expected).abs() <= expected * f32::EPSILON,
            "{name}: {read} {expected}"
        );
    }
}

fn v(x: u32, y: u32) -> u32 {
    1 + x + 16 * y
}

#[test]
fn png_of_every_kind() {
    let rgb = |x, y| [3 * v(x, y), 255 - 3 * v(x, y), 0];
    assert_codes("rgb8.png", 8, rgb);
    assert_codes("rgba8.png", 8, rgb);
    assert_codes("grey8.png", 8, |x, y| [3 * v(x, y); 3]);
    assert_codes("grey-alpha8.png", 8, |x, y| [3 * v(x, y); 3]);
    assert_codes("grey16.png", 16, |x, y| [900 * v(x, y); 3]);
    assert_codes("rgb16.png", 16, |x, y| [900 * v(x, y), 65535 - v(x, y), 0]);
    assert_codes("grey1.png", 1, |x, y| [u32::from((x + y) % 2 == 0); 3]);
    assert_codes("palette.png", 8, |x, y| {
        let i = (x + y) % 16;
        [3 * i, 255 - i, 7 * i]
    });
}

#[test]
fn png_that_says_srgb_in_other_words() {
    let rgb = |x, y| [3 * v(x, y), 255 - 3 * v(x, y), 0];
    assert_codes("gamma-srgb.png", 8, rgb);
    assert_codes("cicp-srgb.png", 8, rgb);
}
