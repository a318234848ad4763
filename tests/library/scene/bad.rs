//! What is wrong with a scene, and where: line and column, and the message as a terminal shows it.

use std::path::Path;

use insta::assert_snapshot;
use miette::Severity;
use vkpt::scene::{Diagnostic, Errors, Read, parse};

use super::read_lines;

/// "E" or "W", line, column (0: the whole file).
type Found = (&'static str, usize, usize);

fn found(diagnostics: &[Diagnostic]) -> Vec<Found> {
    let row = |d: &Diagnostic| {
        let severity = match d.severity {
            Severity::Error => "E",
            _ => "W",
        };
        let (line, column) = d.place.map_or((0, 0), |place| (place.line, place.column));
        (severity, line, column)
    };
    diagnostics.iter().map(row).collect()
}

fn all_of(read: Result<Read, Errors>) -> Vec<Diagnostic> {
    read.map_or_else(|errors| errors.diagnostics, |read| read.warnings)
}

/// As a terminal without colours shows them.
fn draw(diagnostics: &[Diagnostic]) -> String {
    diagnostics.iter().map(Diagnostic::drawn).collect()
}

/// A line, and its one diagnostic: severity and column.
type Row = (&'static str, &'static str, usize);

/// Lines by topic. The snapshots have the texts of their diagnostics.
#[rustfmt::skip] // a row a line
const ONE: &[(&str, &[Row])] = &[
    ("numbers", &[
        ("sphere 0 0 0 2.5b", "W", 14),
        ("sphere 0 0 0 1e", "W", 14),
        ("\tsphere 0 0 1.2.3 1", "W", 13),
        ("sphere 0 0 b 1", "E", 12),
        ("sphere 0 . 0 1", "E", 10),
        ("sphere 0 0 nan 1", "E", 12),
        ("sphere 0 0 0 -inf", "E", 14),
        ("sphere 0 0 1e999 1", "E", 12),
        ("sphere 0 0 0 1e39", "E", 14),
        ("sphere 0 0 0 1e-60", "E", 14),
        ("sphere ü 0 0 1", "E", 8),
    ]),
    ("arguments", &[
        ("sphere 0 0 0", "E", 13),
        ("sphere", "E", 7),
        ("sphere 0 0 0 1 # a ball", "W", 16),
        ("light 1 1", "E", 10),
        ("light 1 1 1 1", "W", 13),
        ("mesh", "E", 5),
        ("brdf 1 1 1 0 0 0", "E", 17),
        ("brdf 1 1 1 0 0 0 1 .5", "E", 20),
        ("brdf 1 1 1 0 0 0 1 .5 .5", "E", 20),
        ("brdf 1 1 1 0 0 0 1 .5 .5 .5", "E", 20),
        ("brdf 1 1 1 0 0 0 1 0 0 0 1 7", "W", 28),
        ("brdf 1 1 1 0 0 0 1 red", "W", 20),
        ("brdf 1 1 1 0 0 0 1 0 0 x 1", "E", 24),
    ]),
    ("ranges", &[
        ("sphere 0 0 0 0", "E", 14),
        ("sphere 0 0 0 -1", "E", 14),
        ("box 0 0 0 1 0 1", "E", 13),
        ("cylinder 0 0 0 0 0 0 1", "E", 16),
        ("cylinder 0 0 0 0 0 1 0", "E", 22),
        ("light 1 -1 1", "E", 9),
        ("background 1 1 -1", "E", 16),
        ("brdf -.1 1 1 0 0 0 1", "E", 6),
        ("brdf 1 1 1 0 0 -1 1", "E", 16),
        ("brdf 0 0 0 0 0 0 1 0 0 -1 1", "E", 24),
        ("brdf 1 1 1 0 0 0 -1", "E", 18),
        ("brdf 0 0 0 0 0 0 1 1 1 1 0", "E", 26),
        ("brdf 0 0 0 0 0 0 1 0 1 0 -1", "E", 26),
        ("brdf 1.5 0 0 0 0 0 1", "W", 6),
        ("brdf 0 0 0 0 2 0 1", "W", 14),
        ("brdf 0 0 0 0 0 0 1 1 1 3 1", "W", 24),
        ("brdf 0 .1 0 0 0 0 1 .1 0 0 1", "W", 1),
        ("lens -1 4", "E", 6),
        ("lens 1 0", "E", 8),
        ("lens 1 -4", "E", 8),
        ("lens 1 1e-60", "E", 8),
        ("lens 1e39 4", "E", 6),
        ("lens 1 inf", "E", 8),
        ("lens wide 4", "E", 6),
        ("lens .1", "E", 8),
        ("lens", "E", 5),
        ("lens .1 4 5", "W", 11),
    ]),
    ("words", &[
        ("sphre 0 0 0 1", "W", 1),
        ("frobnicate 1 2", "W", 1),
        ("distribution gxg", "E", 14),
        ("distribution", "E", 13),
        ("fresnel exactly", "E", 9),
        ("fresnel exact 1", "W", 15),
    ]),
    ("twice", &[
        ("screen 5 5", "W", 1),
        ("camera 0 0 0 1", "W", 1),
    ]),
    ("meshes", &[
        ("mesh dwarf.x 0 0 0 1", "E", 6),
        ("mesh dwarf 0 0 0 1", "E", 6),
        ("mesh none.ply 0 0 0 1", "E", 6),
    ]),
];

#[test]
fn each_mistake_is_printed_once_and_in_its_place() {
    for (topic, rows) in ONE {
        let mut drawn = String::new();
        for (line, severity, column) in *rows {
            let diagnostics = all_of(read_lines(line));
            assert_eq!(found(&diagnostics), [(*severity, 3, *column)], "{line}");
            drawn += &draw(&diagnostics);
        }
        assert_snapshot!(*topic, drawn);
    }
}

/// The same at the camera and the screen: text of the whole file; severity, line and column of each diagnostic.
#[test]
fn views_are_checked_too() {
    #[rustfmt::skip] // a row a line
    let rows: &[(&str, &[Found])] = &[
        ("screen 4 3", &[("E", 0, 0)]),
        ("camera 0 0 0 1", &[("E", 0, 0)]),
        ("", &[("E", 0, 0), ("E", 0, 0)]),
        // A command that is there but wrong is not missing as well.
        ("screen 0 3\ncamera 0 0 0 1", &[("E", 1, 8)]),
        ("screen 4 -3\ncamera 0 0 0 1", &[("E", 1, 10)]),
        ("screen 4.5 3\ncamera 0 0 0 1", &[("E", 1, 8)]),
        ("screen 4 16385\ncamera 0 0 0 1", &[("E", 1, 10)]),
        ("screen 16384 1\ncamera 0 0 0 1", &[]),
        ("screen 4 3\ncamera 0 0 0 0", &[("E", 2, 14)]),
        ("screen 4 3\ncamera 0 0 0 -1", &[("E", 2, 14)]),
        ("lens 1 2\nscreen 4 3\ncamera 0 0 0 1\nlens 3 4", &[("W", 4, 1)]),
        ("screen 4 3\ncamera 0 0 0 1 x", &[("E", 2, 17)]),
        ("screen 4 3\ncamera 0 0 0 1 x y 9", &[("E", 2, 18), ("W", 2, 20)]),
        ("screen 4 3\ncamera 0 0 0 1 w 9", &[("W", 2, 16)]),
        ("screen 4 3\ncamera 0 0 0 1 q 0 0 0 0", &[("E", 2, 16)]),
        ("screen 4 3\ncamera 0 0 0 1 x 1 a 9 0 0 0", &[("E", 2, 20)]),
        ("screen 4 3\ncamera 0 0 0 1 q 1 0 0", &[("E", 2, 23)]),
    ];
    let mut drawn = String::new();
    for (text, expected) in rows {
        let diagnostics = all_of(parse(text, Path::new("a.scn"), false));
        assert_eq!(found(&diagnostics), *expected, "{text}");
        drawn += &draw(&diagnostics);
    }
    assert_snapshot!(drawn);
}

#[test]
fn all_mistakes_of_a_line_and_of_a_file_are_printed_at_once() {
    let lines = "brdf -1 0 0 0 x 0 1 2 0 0 0\nsphere 0 0 0 1\nmesh none.ply x 0 0 0";
    assert_snapshot!(draw(&all_of(read_lines(lines))));
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
        let diagnostics = all_of(read_lines(line));
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
    let rows = ONE.iter().flat_map(|(_, rows)| *rows);
    for (line, severity, _) in rows.filter(|row| row.1 == "W") {
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
        let [only] = &errors.diagnostics[..] else {
            panic!("{errors}")
        };
        assert!(only.message.starts_with(start), "{only}");
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("picture.scn");
    std::fs::write(&path, b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR").expect("a file");
    let errors = vkpt::scene::read(&path, false).expect_err("a picture");
    assert_eq!(
        errors.diagnostics[0].message,
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
            errors.diagnostics[0].message,
            format!("{name}: it is UTF-16: save it as UTF-8")
        );
    }
    std::fs::write(&path, b"# caf\xe9 in Latin-1\nscreen 4 3\ncamera 0 0 0 1").expect("a file");
    assert!(vkpt::scene::read(&path, true).is_ok());
}
