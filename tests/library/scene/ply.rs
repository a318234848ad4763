//! PLY files, whole and broken.

use std::path::Path;

use glam::DVec3;
use vkpt::scene::{MeshError, MeshFile, parse_mesh, read_mesh};

use super::ply_writer::Scalar::{F32, F64, I8, I16, I32, U8, U16, U32};
use super::ply_writer::{ENCODINGS, Encoding, Scalar, file};

fn read(bytes: &[u8]) -> Result<MeshFile, MeshError> {
    parse_mesh(bytes, Path::new("mesh.PLY"))
}

/// A square and a triangle below it, with normals, between unknown properties and elements.
const DRESSED: &str = "comment a test\nobj_info nothing\nelement vertex 5\nproperty uchar red\nproperty float x\n\
    property float y\nproperty list uchar short tags\nproperty float z\nproperty double nx\nproperty double ny\n\
    property double nz\nelement lamp 2\nproperty double power\nelement face 2\nproperty uint id\n\
    property list uchar int vertex_indices\nproperty float area\n";

fn dressed_rows() -> Vec<Vec<Scalar>> {
    let vertex = |x: f32, y: f32, n: [f64; 3]| {
        let [nx, ny, nz] = n.map(F64);
        vec![
            U8(255),
            F32(x),
            F32(y),
            U8(2),
            I16(-3),
            I16(4),
            F32(0.1),
            nx,
            ny,
            nz,
        ]
    };
    let up = [0.0, 0.0, 2.0];
    vec![
        vertex(0.0, 0.0, up),
        vertex(1.0, 0.0, up),
        vertex(1.0, 1.5, [0.0, -4.0, 0.0]),
        vertex(0.0, 1.0, up),
        vertex(0.5, -1e-7, [0.0; 3]),
        vec![F64(1.0)],
        vec![F64(2.5)],
        vec![U32(9), U8(4), I32(0), I32(1), I32(2), I32(3), F32(1.25)],
        vec![U32(10), U8(3), I32(0), I32(4), I32(1), F32(0.5)],
    ]
}

#[test]
fn three_encodings_are_one_mesh() {
    let z = f64::from(0.1_f32);
    let expected = MeshFile {
        files: Vec::new(),
        positions: vec![
            DVec3::new(0.0, 0.0, z),
            DVec3::new(1.0, 0.0, z),
            DVec3::new(1.0, 1.5, z),
            DVec3::new(0.0, 1.0, z),
            DVec3::new(0.5, f64::from(-1e-7_f32), z),
        ],
        normals: Some(vec![
            DVec3::Z,
            DVec3::Z,
            DVec3::NEG_Y,
            DVec3::Z,
            DVec3::ZERO,
        ]),
        triangles: vec![[0, 1, 2], [0, 2, 3], [0, 4, 1]],
        warnings: vec![
            "1 normal is zero or not finite: the faces' own normals are used there".into(),
        ],
    };
    for encoding in ENCODINGS {
        let mesh = read(&file(encoding, DRESSED, &dressed_rows())).expect("a whole file");
        assert_eq!(mesh, expected, "{encoding:?}");
    }
}

#[test]
fn any_scalar_type_will_do_and_faces_may_come_first() {
    type Make = (&'static str, fn(u8) -> Scalar);
    let integers: [Make; 6] = [
        ("char", |i| I8(i as i8)),
        ("uint8", U8),
        ("short", |i| I16(i.into())),
        ("uint16", |i| U16(i.into())),
        ("int", |i| I32(i.into())),
        ("uint32", |i| U32(i.into())),
    ];
    let all: [Make; 8] = [
        integers[0],
        integers[1],
        integers[2],
        integers[3],
        integers[4],
        integers[5],
        ("float32", |i| F32(i.into())),
        ("double", |i| F64(i.into())),
    ];
    for encoding in ENCODINGS {
        for (list, count) in integers {
            for (of, index) in integers {
                for (name, coordinate) in all {
                    let header = format!(
                        "element face 1\nproperty list {list} {of} vertex_index\nelement vertex 3\n\
                         property {name} z\nproperty {name} y\nproperty {name} x\n"
                    );
                    let mut rows = vec![vec![count(3), index(2), index(0), index(1)]];
                    rows.extend(
                        [[1, 2, 3], [4, 5, 6], [7, 8, 100]].map(|row| row.map(coordinate).to_vec()),
                    );
                    let mesh = read(&file(encoding, &header, &rows)).expect(&header);
                    assert_eq!(mesh.positions[2], DVec3::new(100.0, 8.0, 7.0), "{header}");
                    assert_eq!(
                        (mesh.triangles, mesh.normals),
                        (vec![[2, 0, 1]], None),
                        "{header}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_file_cut_anywhere_is_an_error_and_never_a_panic() {
    for encoding in ENCODINGS {
        let whole = file(encoding, DRESSED, &dressed_rows());
        for length in 0..whole.len() {
            let cut = read(&whole[..length]);
            // ASCII: without its last line's end a file is whole, and its last number may lose digits.
            let tail = if encoding == Encoding::Ascii {
                "0.5\n".len()
            } else {
                0
            };
            match length + tail < whole.len() {
                true => assert!(
                    cut.is_err(),
                    "{encoding:?}, {length} of {}: {cut:?}",
                    whole.len()
                ),
                false => drop(cut),
            }
        }
    }
}

const HEADER: &str = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
    element face 1\nproperty list uchar int vertex_indices\n";

fn triangle(x: f32, corners: [i32; 3]) -> Vec<Vec<Scalar>> {
    let [a, b, c] = corners.map(I32);
    vec![
        vec![F32(x), F32(0.0), F32(0.0)],
        vec![F32(1.0), F32(0.0), F32(0.0)],
        vec![F32(0.0), F32(1.0), F32(0.0)],
        vec![U8(3), a, b, c],
    ]
}

#[test]
fn mistakes_are_named() {
    let rows = triangle(0.0, [0, 1, 2]);
    for encoding in ENCODINGS {
        let message = |header: &str, rows: &[Vec<Scalar>]| match read(&file(encoding, header, rows))
        {
            Ok(mesh) => panic!("{header} {rows:?} read as {mesh:?}"),
            Err(error) => error.to_string(),
        };
        assert_eq!(
            message(HEADER, &triangle(0.0, [0, 1, 3])),
            "face 0 (from 0) refers to vertex 3, but there are 3"
        );
        assert_eq!(
            message(HEADER, &triangle(0.0, [0, -1, 2])),
            "face 0 (from 0) refers to vertex -1, but there are 3"
        );
        let mut line = rows.clone();
        line[3] = vec![U8(2), I32(0), I32(1)];
        assert_eq!(
            message(HEADER, &line),
            "it has no faces: 1 face with fewer than three corners is skipped"
        );
        let none = HEADER.replace("face 1", "face 0");
        assert_eq!(message(&none, &rows[..3]), "it has no faces");
        let flat = HEADER.replace("property float z\n", "");
        assert_eq!(
            message(&flat, &rows),
            "it has no element `vertex` with properties x, y, z"
        );
        let cloud = HEADER.split("element face").next().expect("the vertices");
        let no_faces =
            "it has no element `face` with a list of integers, vertex_index or vertex_indices";
        assert_eq!(message(cloud, &rows), no_faces);
        assert_eq!(
            message(&HEADER.replace("uchar int", "uchar float"), &rows),
            no_faces
        );
        let twice = HEADER.replace("property float y\n", "property float x\nproperty float y\n");
        assert_eq!(
            message(&twice, &rows),
            "its line 5 repeats an earlier name: `property float x`"
        );
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let words = message(HEADER, &triangle(bad, [0, 1, 2]));
            assert_eq!(words, "vertex 0 (from 0) is not finite in single precision");
        }
    }
}

/// The numbers that C++ streams write and read, and the other numbers of ASCII files.
#[test]
fn numbers_may_begin_or_end_with_a_point() {
    let whole = file(Encoding::Ascii, HEADER, &triangle(0.0, [0, 1, 2]));
    let whole = String::from_utf8(whole).expect("text");
    let with = |x: &str| whole.replacen("\n0 0 0\n", &format!("\n{x} 1. -.5\n"), 1);
    let rows = [
        (".5", 0.5),
        ("-.25", -0.25),
        ("+2.", 2.0),
        ("1.e2", 100.0),
        ("-.5E-1", -0.05),
        ("1.5", 1.5),
    ];
    for (text, x) in rows {
        let mesh = read(with(text).as_bytes()).expect(text);
        let expected = DVec3::new(f64::from(x as f32), 1.0, -0.5);
        assert_eq!(mesh.positions[0], expected, "{text}");
    }
    for text in [".", "-.", "1..5", ".e5", "1.2.3"] {
        let words = read(with(text).as_bytes()).expect_err(text).to_string();
        assert_eq!(
            words,
            format!("its line 10 cannot be read: `{text} 1. -.5`")
        );
    }
}

#[test]
fn lines_that_are_not_understood_are_quoted() {
    let whole = file(Encoding::Ascii, HEADER, &triangle(0.0, [0, 1, 2]));
    let whole = String::from_utf8(whole).expect("text");
    let rows = [
        (
            "\n0 0 0\n",
            "\nabc 0 0\n",
            "its line 10 cannot be read: `abc 0 0`",
        ),
        // A stream of numbers: the first of the face's are taken for a vertex, and two are left.
        (
            "\n0 0 0\n",
            "\n0 0\n",
            "its line 13 is more than its header declares: `3 0 1 2`",
        ),
        (
            "3 0 1 2",
            "-3 0 1 2",
            "its line 13 cannot be read: `-3 0 1 2`",
        ),
        (
            "3 0 1 2",
            "3 0 1.5 2",
            "its line 13 cannot be read: `3 0 1.5 2`",
        ),
        (
            "float y",
            "flt y",
            "its line 5 cannot be read: `property flt y`",
        ),
        (
            "float y",
            "flt \u{7}y",
            "its line 5 cannot be read: `property flt \u{fffd}y`",
        ),
        ("ply\n", "", "its line 1 cannot be read: `format ascii 1.0`"),
        (
            "3 0 1 2\n",
            "\n\n\n\n\n\n\n\n\n",
            "it ends in row 1 of the 1 of its element `face`",
        ),
    ];
    for (from, to, message) in rows {
        let damaged = whole.replacen(from, to, 1);
        assert_ne!(damaged, whole);
        let error = read(damaged.as_bytes()).expect_err(message);
        assert_eq!(error.to_string(), message);
    }
    for bytes in [&b"solid cube\n"[..], b"", b"ply\n", b"ply\n\xff\n"] {
        assert!(matches!(read(bytes), Err(MeshError::Malformed(_))));
    }
}

#[test]
fn files_are_read_or_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| folder.path().join(name);
    let bytes = file(Encoding::Little, HEADER, &triangle(0.0, [0, 1, 2]));
    std::fs::write(path("mesh.ply"), &bytes).expect("a file");
    std::fs::create_dir(path("folder.ply")).expect("a folder");
    let whole = read_mesh(&path("mesh.ply")).expect("a whole file");
    assert_eq!(whole, read(&bytes).expect("a whole file"));
    assert!(matches!(
        read_mesh(&path("none.ply")),
        Err(MeshError::Missing)
    ));
    assert!(matches!(
        read_mesh(&path("none.stl")),
        Err(MeshError::Format)
    ));
    assert!(matches!(
        read_mesh(&path("folder.ply")),
        Err(MeshError::Unreadable(_))
    ));
    assert!(matches!(read_mesh(Path::new("")), Err(MeshError::Format)));
    // A device never ends, and a pipe may never begin.
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("/dev/zero", path("zero.ply")).expect("a link");
        let pipe = std::process::Command::new("mkfifo")
            .arg(path("pipe.obj"))
            .status();
        assert!(pipe.expect("mkfifo runs").success());
        for name in ["zero.ply", "pipe.obj"] {
            let error = read_mesh(&path(name)).expect_err(name);
            assert_eq!(error.to_string(), "is not a regular file");
        }
    }
}

/// Headers whose counts would take a machine's memory, or its night, if they were believed.
#[test]
fn absurd_counts_are_refused_at_once() {
    let rows = triangle(0.0, [0, 1, 2]);
    let many = 1_000_000_000_000_u64;
    for encoding in ENCODINGS {
        for n in [many, u64::MAX, 1 << 62] {
            let vertices = HEADER.replace("vertex 3", &format!("vertex {n}"));
            let faces = HEADER.replace("face 1", &format!("face {n}"));
            // No property: an element takes no byte in a binary file, so any number of them would fit.
            let empty = format!("element nothing {n}\n{HEADER}");
            for header in [&vertices, &faces] {
                assert!(read(&file(encoding, header, &rows)).is_err(), "{header}");
            }
            assert!(read(&file(encoding, &empty, &rows)).is_ok(), "{empty}");
        }
        let header = HEADER.replace("uchar int", "uint int");
        let mut rows = rows.clone();
        rows[3][0] = U32(u32::MAX);
        assert!(read(&file(encoding, &header, &rows)).is_err());
    }
}

#[test]
fn damaged_files_never_panic() {
    let mut random = super::fuzz::Random(1);
    for encoding in ENCODINGS {
        let whole = file(encoding, DRESSED, &dressed_rows());
        for _ in 0..600 {
            let mut bytes = whole.clone();
            for _ in 0..=random.below(4) {
                let at = random.below(bytes.len());
                match random.below(3) {
                    0 => bytes[at] = random.next() as u8,
                    1 => drop(bytes.remove(at)),
                    _ => bytes[at] ^= 1 << random.below(8),
                }
            }
            if let Ok(mesh) = read(&bytes) {
                let vertices = mesh.positions.len() as u32;
                assert!(
                    mesh.triangles
                        .iter()
                        .flatten()
                        .all(|&index| index < vertices)
                );
                assert!(mesh.positions.iter().all(|p| p.is_finite()));
            }
        }
    }
}
