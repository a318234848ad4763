//! Films to write, the files that they become, and files of other programs.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use vkpt::film::Film;
use vkpt::image::{Format, Frame, Labels, encode};

/// A film with values of every size, negative zero and the largest finite number among them.
pub fn film() -> Film {
    let values = [
        0.0f32,
        -0.0,
        1e-30,
        0.002,
        0.18,
        0.5,
        1.0,
        1.5,
        37.25,
        f32::MAX,
        1.0 / 3.0,
        0.999_999_94,
    ];
    let rgb = (0..35)
        .map(|i| {
            [
                values[i % 12],
                values[(5 * i + 1) % 12],
                values[(7 * i + 2) % 12],
            ]
        })
        .collect();
    Film {
        width: 7,
        height: 5,
        rgb,
    }
}

pub fn encoded(film: &Film, format: Format, exposure: f64) -> Vec<u8> {
    let notes = [
        ("scene", "scènes/glass.scn".to_owned()),
        ("spp", "64".to_owned()),
        ("seed", "0".to_owned()),
    ];
    let labels = Labels {
        exposure,
        software: "vkpt 0.0",
        notes: &notes,
    };
    let frame = Frame {
        film,
        origin: [3, 2],
        full: [20, 10],
        channels: &[],
    };
    let mut out = Cursor::new(Vec::new());
    encode(&frame, format, &labels, &mut out).expect("encoded");
    out.into_inner()
}

/// A file that data/make.py wrote.
pub fn data(name: &str) -> PathBuf {
    Path::new("tests/data/image").join(name)
}

pub fn bits(rgb: &[[f32; 3]]) -> Vec<u32> {
    rgb.as_flattened().iter().map(|v| v.to_bits()).collect()
}
