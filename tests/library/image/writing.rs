//! Pictures read back by their formats' crates: pixels, windows, header, and the same bytes each time.

use std::io::Cursor;

use vkpt::film::Film;
use vkpt::image::{Format, Frame, Labels, encode};

use super::films::{encoded, film};

fn decode_png(bytes: &[u8]) -> (png::OutputInfo, Vec<u8>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes))
        .read_info()
        .expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("pixels");
    (info, pixels)
}

#[test]
fn an_exr_keeps_every_bit() {
    use exr::prelude::*;
    let film = film();
    let bytes = encoded(&film, Format::Exr, 3.0);
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| vec![[0f32; 3]; size.area()],
            |pixels, Vec2(x, y), (r, g, b): (f32, f32, f32)| pixels[y * 7 + x] = [r, g, b],
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(&bytes))
        .expect("an EXR");
    let bits = |rgb: &[[f32; 3]]| {
        rgb.iter()
            .flatten()
            .map(|v| v.to_bits())
            .collect::<Vec<_>>()
    };
    assert_eq!(bits(&image.layer_data.channel_data.pixels), bits(&film.rgb));

    let header = &image.layer_data.attributes;
    assert_eq!(
        image.attributes.display_window,
        IntegerBounds::from_dimensions((20, 10))
    );
    assert_eq!(
        (header.layer_position, image.layer_data.size),
        (Vec2(3, 2), Vec2(7, 5))
    );
    assert_eq!(header.software_name, Some(Text::from("vkpt 0.0")));
    let comments = header.comments.as_ref().expect("comments").bytes();
    assert_eq!(
        comments,
        "scene: scènes/glass.scn\nspp: 64\nseed: 0\n".as_bytes()
    );
}

#[test]
fn an_exr_has_the_same_bytes_each_time() {
    let film = film();
    let first = encoded(&film, Format::Exr, 0.0);
    // An attribute order taken from a hash map would agree this often once in 2¹⁰⁰.
    assert!((0..100).all(|_| encoded(&film, Format::Exr, 0.0) == first));
}

#[test]
fn a_png_has_srgb_codes() {
    // Radiance and its code. Each code was worked out by hand from IEC 61966-2-1:
    // 0.002 × 12.92 × 255 = 6.59; (1.055 × 0.18^(1/2.4) − 0.055) × 255 = 117.65; 0.5: 187.52; 1/3: 156.19.
    let codes = [
        (0.002, 7),
        (0.18, 118),
        (0.5, 188),
        (1.0 / 3.0, 156),
        (1.0, 255),
        (9.0, 255),
        (-1.0, 0),
        (0.0, 0),
    ];
    let rgb = codes
        .iter()
        .map(|&(radiance, _)| [radiance, 0.0, radiance])
        .collect();
    let film = Film {
        width: 4,
        height: 2,
        rgb,
    };
    let bytes = encoded(&film, Format::Png, 0.0);
    let (info, pixels) = decode_png(&bytes);
    assert_eq!(
        (info.width, info.height, info.color_type),
        (4, 2, png::ColorType::Rgb)
    );
    assert_eq!(
        pixels,
        codes
            .iter()
            .flat_map(|&(_, code)| [code, 0, code])
            .collect::<Vec<u8>>()
    );
    assert_eq!(bytes, encoded(&film, Format::Png, 0.0));
}

#[test]
fn exposure_counts_in_stops() {
    let film = Film {
        width: 1,
        height: 1,
        rgb: vec![[0.125, 0.5, 2.0]],
    };
    let brighter = Film {
        width: 1,
        height: 1,
        rgb: vec![[0.5, 2.0, 8.0]],
    };
    let pixels = |film, exposure| decode_png(&encoded(film, Format::Png, exposure)).1;
    assert_eq!(pixels(&film, 2.0), pixels(&brighter, 0.0));
    assert_eq!(pixels(&brighter, -2.0), pixels(&film, 0.0));
    assert_eq!(
        encoded(&film, Format::Exr, 2.0),
        encoded(&film, Format::Exr, 0.0)
    );
}

#[test]
fn a_film_of_the_wrong_size_is_refused() {
    let film = Film {
        width: 2,
        height: 2,
        rgb: vec![[0.0; 3]; 3],
    };
    let frame = Frame {
        film: &film,
        origin: [0, 0],
        full: [2, 2],
        channels: &[],
    };
    let labels = Labels {
        exposure: 0.0,
        software: "vkpt",
        notes: &[],
    };
    for format in [Format::Png, Format::Hdr, Format::Exr] {
        let mut out = Cursor::new(Vec::new());
        let error = encode(&frame, format, &labels, &mut out).expect_err("must be refused");
        assert_eq!(
            error.to_string(),
            "the picture is 2×2 pixels, but its film has 3"
        );
        assert!(out.into_inner().is_empty());
    }
}

#[test]
fn endings_name_formats() {
    let of = |name: &str| Format::of(name.as_ref());
    assert_eq!([of("a.png"), of("b/a.PNG")], [Some(Format::Png); 2]);
    assert_eq!([of("a.hdr"), of("a.HDR")], [Some(Format::Hdr); 2]);
    assert_eq!([of("a.exr"), of("a.b.Exr")], [Some(Format::Exr); 2]);
    assert_eq!([of("a.jpg"), of("png"), of(".png"), of("a.")], [None; 4]);
}
