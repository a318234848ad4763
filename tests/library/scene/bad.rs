//! Errors of a scene: line, column and message.

use std::path::Path;

use miette::Severity;
use vkpt::scene::{Diagnostic, parse};

use super::read_lines;

/// "E" or "W", line, column (0: the whole file), message.
type Said = (&'static str, usize, usize, String);

/// The same, as a table has it.
type Row = (&'static str, usize, usize, &'static str);

fn said(diagnostics: &[Diagnostic]) -> Vec<Said> {
    let row = |d: &Diagnostic| {
        let severity = if d.severity == Severity::Error {
            "E"
        } else {
            "W"
        };
        let (line, column) = d.place.map_or((0, 0), |place| (place.line, place.column));
        (severity, line, column, d.message.clone())
    };
    diagnostics.iter().map(row).collect()
}

/// All that is said about a scene whose third line begins `lines`.
fn about(lines: &str) -> Vec<Said> {
    match read_lines(lines) {
        Ok(read) => said(&read.warnings),
        Err(errors) => said(&errors.diagnostics),
    }
}

/// One line each, and the one thing that is said about it: severity, column, message.
#[rustfmt::skip] // a row a line
const ONE: &[(&str, &str, usize, &str)] = &[
    // Numbers.
    ("sphere 0 0 0 2.5b", "W", 14, "`2.5b` is read as 2.5"),
    ("sphere 0 0 0 1e", "W", 14, "`1e` is read as 1"),
    ("\tsphere 0 0 1.2.3 1", "W", 13, "`1.2.3` is read as 1.2"),
    ("sphere 0 0 b 1", "E", 12, "`b` is not a number"),
    ("sphere 0 . 0 1", "E", 10, "`.` is not a number"),
    ("sphere 0 0 nan 1", "E", 12, "`nan` is not a finite number"),
    ("sphere 0 0 0 -inf", "E", 14, "`-inf` is not a finite number"),
    ("sphere 0 0 1e999 1", "E", 12, "`1e999` is beyond the range of single precision"),
    ("sphere 0 0 0 1e39", "E", 14, "`1e39` is beyond the range of single precision"),
    ("sphere 0 0 0 1e-60", "E", 14, "the radius is zero in single precision"),
    ("sphere ü 0 0 1", "E", 8, "`ü` is not a number"),
    // Too few, too many.
    ("sphere 0 0 0", "E", 13, "`sphere` has too few arguments"),
    ("sphere", "E", 7, "`sphere` has too few arguments"),
    ("sphere 0 0 0 1 # a ball", "W", 16, "`sphere` has more arguments than it takes"),
    ("light 1 1", "E", 10, "`light` has too few arguments"),
    ("light 1 1 1 1", "W", 13, "`light` has more arguments than it takes"),
    ("mesh", "E", 5, "`mesh` has too few arguments"),
    ("brdf 1 1 1 0 0 0", "E", 17, "`brdf` has too few arguments"),
    ("brdf 1 1 1 0 0 0 1 .5", "E", 20, "`brdf` takes 7 numbers or 11, not 8"),
    ("brdf 1 1 1 0 0 0 1 .5 .5", "E", 20, "`brdf` takes 7 numbers or 11, not 9"),
    ("brdf 1 1 1 0 0 0 1 .5 .5 .5", "E", 20, "`brdf` takes 7 numbers or 11, not 10"),
    ("brdf 1 1 1 0 0 0 1 0 0 0 1 7", "W", 28, "`brdf` has more arguments than it takes"),
    ("brdf 1 1 1 0 0 0 1 red", "W", 20, "`brdf` has more arguments than it takes"),
    ("brdf 1 1 1 0 0 0 1 0 0 x 1", "E", 24, "`x` is not a number"),
    // Legal ranges.
    ("sphere 0 0 0 0", "E", 14, "the radius must be above 0"),
    ("sphere 0 0 0 -1", "E", 14, "the radius must be above 0"),
    ("box 0 0 0 1 0 1", "E", 13, "a side of the box is zero"),
    ("cylinder 0 0 0 0 0 0 1", "E", 16, "the axis of the cylinder is zero"),
    ("cylinder 0 0 0 0 0 1 0", "E", 22, "the radius must be above 0"),
    ("light 1 -1 1", "E", 9, "radiance must not be negative"),
    ("background 1 1 -1", "E", 16, "radiance must not be negative"),
    ("brdf -.1 1 1 0 0 0 1", "E", 6, "Kd must not be negative"),
    ("brdf 1 1 1 0 0 -1 1", "E", 16, "Ks must not be negative"),
    ("brdf 0 0 0 0 0 0 1 0 0 -1 1", "E", 24, "Kt must not be negative"),
    ("brdf 1 1 1 0 0 0 -1", "E", 18, "alpha must not be negative"),
    ("brdf 0 0 0 0 0 0 1 1 1 1 0", "E", 26, "the index of refraction must be above 0"),
    ("brdf 0 0 0 0 0 0 1 0 1 0 -1", "E", 26, "the index of refraction must be above 0"),
    ("brdf 1.5 0 0 0 0 0 1", "W", 6, "Kd is above 1"),
    ("brdf 0 0 0 0 2 0 1", "W", 14, "Ks is above 1"),
    ("brdf 0 0 0 0 0 0 1 1 1 3 1", "W", 24, "Kt is above 1"),
    ("brdf 0 .1 0 0 0 0 1 .1 0 0 1", "W", 1, "Kd and Kt are both above 0"),
    ("lens -1 4", "E", 6, "the radius of the lens must not be negative"),
    ("lens 1 0", "E", 8, "the focal distance must be above 0"),
    ("lens 1 -4", "E", 8, "the focal distance must be above 0"),
    ("lens 1 1e-60", "E", 8, "the focal distance is zero in single precision"),
    ("lens 1e39 4", "E", 6, "`1e39` is beyond the range of single precision"),
    ("lens 1 inf", "E", 8, "`inf` is not a finite number"),
    ("lens wide 4", "E", 6, "`wide` is not a number"),
    ("lens .1", "E", 8, "`lens` has too few arguments"),
    ("lens", "E", 5, "`lens` has too few arguments"),
    ("lens .1 4 5", "W", 11, "`lens` has more arguments than it takes"),
    // Unknown commands and words.
    ("sphre 0 0 0 1", "W", 1, "unknown command `sphre`"),
    ("frobnicate 1 2", "W", 1, "unknown command `frobnicate`"),
    ("distribution gxg", "E", 14, "`distribution` cannot be `gxg`"),
    ("distribution", "E", 13, "`distribution` has too few arguments"),
    ("fresnel exactly", "E", 9, "`fresnel` cannot be `exactly`"),
    ("fresnel exact 1", "W", 15, "`fresnel` has more arguments than it takes"),
    // Twice.
    ("screen 5 5", "W", 1, "`screen` is given more than once"),
    ("camera 0 0 0 1", "W", 1, "`camera` is given more than once"),
    // Meshes.
    ("mesh dwarf.x 0 0 0 1", "E", 6, "dir/dwarf.x: unsupported format; the supported formats are PLY (.ply), OBJ (.obj), glTF (.gltf, .glb)"),
    ("mesh dwarf 0 0 0 1", "E", 6, "dir/dwarf: unsupported format; the supported formats are PLY (.ply), OBJ (.obj), glTF (.gltf, .glb)"),
    ("mesh none.ply 0 0 0 1", "E", 6, "dir/none.ply: no such file"),
];

#[test]
fn each_mistake_is_told_once_and_in_its_place() {
    for (line, severity, column, message) in ONE {
        assert_eq!(
            about(line),
            [(*severity, 3, *column, (*message).to_owned())],
            "{line}"
        );
    }
}

/// The same at the camera and the screen: text of the whole file, and the messages.
#[test]
fn views_are_checked_too() {
    let rows: &[(&str, &[Row])] = &[
        ("screen 4 3", &[("E", 0, 0, "a.scn has no `camera`")]),
        ("camera 0 0 0 1", &[("E", 0, 0, "a.scn has no `screen`")]),
        (
            "",
            &[
                ("E", 0, 0, "a.scn has no `screen`"),
                ("E", 0, 0, "a.scn has no `camera`"),
            ],
        ),
        // A command that is present but wrong is not missing as well.
        (
            "screen 0 3\ncamera 0 0 0 1",
            &[(
                "E",
                1,
                8,
                "the width must be a whole number of pixels above 0",
            )],
        ),
        (
            "screen 4 -3\ncamera 0 0 0 1",
            &[(
                "E",
                1,
                10,
                "the height must be a whole number of pixels above 0",
            )],
        ),
        (
            "screen 4.5 3\ncamera 0 0 0 1",
            &[(
                "E",
                1,
                8,
                "the width must be a whole number of pixels above 0",
            )],
        ),
        (
            "screen 4 16385\ncamera 0 0 0 1",
            &[("E", 1, 10, "the height must be at most 16384 pixels")],
        ),
        ("screen 16384 1\ncamera 0 0 0 1", &[]),
        (
            "screen 4 3\ncamera 0 0 0 0",
            &[("E", 2, 14, "ry must be above 0")],
        ),
        (
            "screen 4 3\ncamera 0 0 0 -1",
            &[("E", 2, 14, "ry must be above 0")],
        ),
        (
            "lens 1 2\nscreen 4 3\ncamera 0 0 0 1\nlens 3 4",
            &[("W", 4, 1, "`lens` is given more than once")],
        ),
        (
            "screen 4 3\ncamera 0 0 0 1 x",
            &[("E", 2, 17, "`camera` has too few arguments")],
        ),
        (
            "screen 4 3\ncamera 0 0 0 1 x y 9",
            &[
                ("E", 2, 18, "`y` is not a number"),
                ("W", 2, 20, "`9` is not a rotation"),
            ],
        ),
        (
            "screen 4 3\ncamera 0 0 0 1 w 9",
            &[("W", 2, 16, "`w` is not a rotation")],
        ),
        (
            "screen 4 3\ncamera 0 0 0 1 q 0 0 0 0",
            &[("E", 2, 16, "a quaternion must not be zero")],
        ),
        (
            "screen 4 3\ncamera 0 0 0 1 x 1 a 9 0 0 0",
            &[("E", 2, 20, "the axis of a rotation must not be zero")],
        ),
        (
            "screen 4 3\ncamera 0 0 0 1 q 1 0 0",
            &[("E", 2, 23, "`camera` has too few arguments")],
        ),
    ];
    for (text, expected) in rows {
        let said = match parse(text, Path::new("a.scn"), false) {
            Ok(read) => said(&read.warnings),
            Err(errors) => said(&errors.diagnostics),
        };
        let expected: Vec<Said> = expected
            .iter()
            .map(|(s, l, c, m)| (*s, *l, *c, (*m).to_owned()))
            .collect();
        assert_eq!(said, expected, "{text}");
    }
}

#[test]
fn all_mistakes_of_a_line_and_of_a_file_are_told_at_once() {
    let expected = [
        ("E", 3, 6, "Kd must not be negative"),
        ("E", 3, 15, "`x` is not a number"),
        ("W", 3, 21, "Kt is above 1"),
        ("E", 3, 27, "the index of refraction must be above 0"),
        ("E", 5, 6, "dir/none.ply: no such file"),
        ("E", 5, 15, "`x` is not a number"),
        ("E", 5, 21, "the scale must be above 0"),
    ];
    let lines = "brdf -1 0 0 0 x 0 1 2 0 0 0\nsphere 0 0 0 1\nmesh none.ply x 0 0 0";
    let said = about(lines);
    let expected: Vec<Said> = expected
        .iter()
        .map(|(s, l, c, m)| (*s, *l, *c, (*m).to_owned()))
        .collect();
    assert_eq!(said, expected);
}

#[test]
fn a_close_word_is_suggested_and_a_far_one_is_not() {
    let rows = [
        ("sphre 1", Some("sphere")),
        ("Sphere 1", Some("sphere")),
        ("spheer 1", Some("sphere")),
        ("boxx 1", Some("box")),
        ("backgruond 1", Some("background")),
        ("cilinder 1", Some("cylinder")),
        ("distribution beckman", Some("beckmann")),
        ("fresnel Exact", Some("exact")),
        ("frobnicate", None),
        ("1", None),
        ("é", None),
    ];
    for (line, word) in rows {
        let diagnostics = match read_lines(line) {
            Ok(read) => read.warnings,
            Err(errors) => errors.diagnostics,
        };
        let help = diagnostics[0]
            .help
            .clone()
            .filter(|help| help.starts_with("did you mean"));
        assert_eq!(
            help,
            word.map(|word| format!("did you mean `{word}`?")),
            "{line}"
        );
    }
}

#[test]
fn the_last_screen_and_camera_count() {
    let scene = read_lines("screen 7 8\ncamera 1 1 1 2")
        .expect("warnings only")
        .scene;
    assert_eq!(
        (scene.screen.width, scene.screen.height, scene.camera.ry),
        (7, 8, 2.0)
    );
}

#[test]
fn colours_above_one_are_clamped() {
    let scene = read_lines("brdf 2 .5 0 0 3 0 1 0 0 4 1\nsphere 0 0 0 1")
        .expect("warnings only")
        .scene;
    let vkpt::scene::MaterialKind::Brdf(brdf) = &scene.materials[0].kind else {
        panic!("no brdf")
    };
    let (kd, ks, kt) = (brdf.kd.to_array(), brdf.ks.to_array(), brdf.kt.to_array());
    assert_eq!(
        (kd, ks, kt),
        ([1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])
    );
}

#[test]
fn strict_turns_every_warning_into_an_error() {
    for (line, severity, ..) in ONE.iter().filter(|row| row.1 == "W") {
        let text = format!("screen 4 3\ncamera 0 0 5 0.5\n{line}");
        let errors = parse(&text, Path::new("dir/test.scn"), true).expect_err(line);
        assert!(
            errors
                .diagnostics
                .iter()
                .all(|d| d.severity == Severity::Error),
            "{severity} {line}"
        );
    }
}

#[test]
fn files_that_are_no_text_are_refused() {
    let rows = [
        ("/dev/null/none.scn", "cannot read "),
        (env!("CARGO_MANIFEST_DIR"), "cannot read "),
    ];
    for (path, start) in rows {
        let errors = vkpt::scene::read(Path::new(path), false).expect_err(path);
        let said = said(&errors.diagnostics);
        assert_eq!(
            (said.len(), said[0].3.starts_with(start)),
            (1, true),
            "{said:?}"
        );
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("picture.scn");
    std::fs::write(&path, b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR").expect("a file");
    let errors = vkpt::scene::read(&path, false).expect_err("a picture");
    assert_eq!(
        said(&errors.diagnostics)[0].3,
        format!("{} is not text: it contains a zero byte", path.display())
    );
    let text = "screen 4 3\ncamera 0 0 0 1\n";
    let big = text.encode_utf16().flat_map(u16::to_be_bytes);
    let little = text.encode_utf16().flat_map(u16::to_le_bytes);
    let marked = [0xff, 0xfe].into_iter().chain(little.clone());
    let encodings: [Vec<u8>; 3] = [big.collect(), little.collect(), marked.collect()];
    for bytes in encodings {
        std::fs::write(&path, bytes).expect("a file");
        let errors = vkpt::scene::read(&path, false).expect_err("UTF-16");
        let name = path.display();
        assert_eq!(
            said(&errors.diagnostics)[0].3,
            format!("{name}: it is UTF-16: save it as UTF-8")
        );
    }
    std::fs::write(&path, b"# caf\xe9 in Latin-1\nscreen 4 3\ncamera 0 0 0 1").expect("a file");
    assert!(vkpt::scene::read(&path, true).is_ok());
}
