//! PLY and OBJ files as exporters, scanners and old machines leave them: each format with each oddity is the mesh that
//! was meant.

use std::path::Path;

use glam::DVec3;
use vkpt::scene::{MeshError, MeshFile, parse_mesh};

const PLY: &str = "ply\nformat ascii 1.0\ncomment a square and a triangle\nelement vertex 5\nproperty float x\n\
    property float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 4\n4 0 1 2 3\n3 0 1 4\n";

const OBJ: &str =
    "# a square and a triangle\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 4\nf 1 2 3 4\nf 1 2 5\n";

const CORNERS: [[f64; 3]; 5] = [
    [0., 0., 0.],
    [2., 0., 0.],
    [2., 2., 0.],
    [0., 2., 0.],
    [1., 1., 4.],
];

/// The corners of each triangle.
fn soup(mesh: &MeshFile) -> Vec<[DVec3; 3]> {
    let corner = |i: u32| mesh.positions[i as usize];
    mesh.triangles.iter().map(|t| t.map(corner)).collect()
}

fn meant() -> Vec<[DVec3; 3]> {
    let triangles = [[0, 1, 2], [0, 2, 3], [0, 1, 4]];
    triangles
        .map(|t| t.map(|i: usize| DVec3::from(CORNERS[i])))
        .to_vec()
}

fn read(bytes: &[u8], name: &str) -> Result<MeshFile, MeshError> {
    parse_mesh(bytes, Path::new(name))
}

/// The file that is meant, with these warnings.
fn is_read(bytes: &[u8], name: &str, warnings: &[&str]) {
    let shown = String::from_utf8_lossy(bytes);
    let mesh = read(bytes, name).unwrap_or_else(|error| panic!("{error}\n{shown}"));
    assert_eq!(soup(&mesh), meant(), "{shown}");
    assert_eq!(mesh.warnings, warnings, "{shown}");
}

/// The PLY file in binary, with lines of its header that end in `ending`.
fn binary(ending: &str, big_endian: bool, header: &str) -> Vec<u8> {
    let name = if big_endian {
        "binary_big_endian"
    } else {
        "binary_little_endian"
    };
    let header = header
        .split_inclusive("end_header\n")
        .next()
        .expect("a header");
    let mut bytes = header
        .replace("ascii", name)
        .replace('\n', ending)
        .into_bytes();
    let mut number = |n: [u8; 4]| {
        let [a, b, c, d] = n;
        bytes.extend(if big_endian { [d, c, b, a] } else { n });
    };
    for x in CORNERS.as_flattened() {
        number((*x as f32).to_le_bytes());
    }
    for face in [&[0, 1, 2, 3][..], &[0, 1, 4]] {
        bytes.push(face.len() as u8);
        for corner in face {
            let n = i32::to_le_bytes(*corner);
            bytes.extend(if big_endian {
                [n[3], n[2], n[1], n[0]]
            } else {
                n
            });
        }
    }
    bytes
}

#[test]
fn lines_end_in_lf_cr_lf_or_cr() {
    for ending in ["\n", "\r\n", "\r"] {
        is_read(PLY.replace('\n', ending).as_bytes(), "a.ply", &[]);
        is_read(OBJ.replace('\n', ending).as_bytes(), "a.obj", &[]);
        for big_endian in [false, true] {
            is_read(&binary(ending, big_endian, PLY), "a.ply", &[]);
        }
    }
    // A body whose first byte is that of a line's end, behind a header of each ending.
    for ending in ["\n", "\r\n", "\r"] {
        let header = "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uchar uchar vertex_index\n\
            property uchar id\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n";
        let header = header.replace(
            "element face 1\n",
            "element first 1\nproperty uchar byte\nelement face 1\n",
        );
        let mut bytes = header.replace('\n', ending).into_bytes();
        bytes.extend([b'\n', 3, 0, 1, 2, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0]);
        let mesh = read(&bytes, "a.ply").expect(ending);
        assert_eq!(
            soup(&mesh),
            [[DVec3::ZERO, DVec3::X, DVec3::Y]],
            "{ending:?}"
        );
    }
    // Lines are counted as they end.
    for ending in ["\n", "\r\n", "\r"] {
        let wrong = OBJ.replace("f 1 2 5", "f 1 2 x").replace('\n', ending);
        let error = read(wrong.as_bytes(), "a.obj")
            .expect_err("not understood")
            .to_string();
        assert_eq!(error, "its line 8 cannot be read: `f 1 2 x`");
        let wrong = PLY.replace("2 2 0", "2 x 0").replace('\n', ending);
        let error = read(wrong.as_bytes(), "a.ply")
            .expect_err("not understood")
            .to_string();
        assert_eq!(error, "its line 13 cannot be read: `2 x 0`");
    }
}

#[test]
fn marks_comments_and_blank_lines() {
    for (text, name, comment) in [(PLY, "a.ply", "comment"), (OBJ, "a.obj", "#")] {
        is_read(format!("\u{feff}{text}").as_bytes(), name, &[]);
        // `caf\xe9` is Latin-1.
        let line = [comment.as_bytes(), b" caf\xe9 \xfc\n"].concat();
        let (first, rest) = text.split_at(text.find('\n').expect("a line") + 1);
        is_read(
            &[first.as_bytes(), &line, rest.as_bytes()].concat(),
            name,
            &[],
        );
        let (head, body) = text.split_at(text.find("0 0 0").expect("a vertex"));
        let head = head.strip_suffix("v ").unwrap_or(head);
        let body = body.strip_prefix("v ").unwrap_or(body);
        let first = if name == "a.obj" { "v " } else { "" };
        let blank = format!("{head}\n \t\n{first}{}\n\n", body.replace('\n', "\n\n"));
        is_read(blank.as_bytes(), name, &[]);
        let wide = format!("{head}{first}{}", body.replace(' ', " \t "));
        is_read(wide.as_bytes(), name, &[]);
        is_read(text.trim_end().as_bytes(), name, &[]);
    }
    for ending in [
        "comment \u{e9}t\u{e9}\n",
        "obj_info caf\u{e9}\n",
        "comment\n",
        "\n",
        "comment ply\n",
    ] {
        let header = PLY.replacen("comment a square and a triangle\n", ending, 1);
        is_read(header.as_bytes(), "a.ply", &[]);
        is_read(&binary("\n", false, &header), "a.ply", &[]);
    }
}

/// To all other readers an ASCII body is a stream of numbers.
#[test]
fn numbers_of_an_element_stand_on_any_lines() {
    let (header, body) = PLY.split_once("end_header\n").expect("a body");
    let numbers: Vec<&str> = body.split_whitespace().collect();
    for separator in ["\n", " ", "\r\n\r\n", " \n "] {
        let text = format!("{header}end_header\n{}", numbers.join(separator));
        is_read(text.as_bytes(), "a.ply", &[]);
    }
    for width in 2..numbers.len() {
        let lines: Vec<_> = numbers.chunks(width).map(|row| row.join(" ")).collect();
        let text = format!("{header}end_header\n{}\n", lines.join("\n"));
        is_read(text.as_bytes(), "a.ply", &[]);
    }
    let more = format!("{PLY}7\n");
    let error = read(more.as_bytes(), "a.ply")
        .expect_err("one too many")
        .to_string();
    assert_eq!(error, "its line 18 is more than its header declares: `7`");
}

#[test]
fn faces_of_fewer_than_three_corners_are_left_out() {
    let one = "1 face with fewer than three corners is skipped";
    let three = "3 faces with fewer than three corners are skipped";
    for (rows, warning) in [
        ("0\n", one),
        ("1 2\n", one),
        ("2 0 1\n", one),
        ("0\n1 2\n2 0 1\n", three),
    ] {
        let count = 2 + rows.lines().count();
        let text = PLY.replace("face 2", &format!("face {count}"));
        is_read(
            text.replace("4 0 1", &format!("{rows}4 0 1")).as_bytes(),
            "a.ply",
            &[warning],
        );
        is_read((text + rows).as_bytes(), "a.ply", &[warning]);
    }
    for (rows, warning) in [
        ("f\n", one),
        ("f 2\n", one),
        ("f 1 2\n", one),
        ("f\nf 2//7\nf 1 2\n", three),
    ] {
        is_read(
            OBJ.replace("f 1 2 5", &format!("{rows}f 1 2 5")).as_bytes(),
            "a.obj",
            &[warning],
        );
    }
}

/// The spellings of C, C++, Windows and Rust.
const NOT_NUMBERS: [&str; 10] = [
    "nan",
    "-nan",
    "NaN",
    "-nan(ind)",
    "nan(0x8000)",
    "1.#QNAN",
    "-1.#IND",
    "1.#QNAN0",
    "-1.#IND00",
    "inf",
];

#[test]
fn normals_without_a_direction_are_those_of_the_face() {
    let one = "1 normal is zero or not finite: the faces' own normals are used there";
    for word in NOT_NUMBERS {
        let declared =
            "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n";
        let mut text = PLY.replace("property float z\n", declared);
        for (i, corner) in CORNERS.iter().enumerate() {
            let normal = if i == 2 {
                format!("0 {word} 1")
            } else {
                "0 0 3".into()
            };
            let [x, y, z] = corner;
            text = text.replacen(
                &format!("\n{x} {y} {z}\n"),
                &format!("\n{x} {y} {z} {normal}\n"),
                1,
            );
        }
        is_read(text.as_bytes(), "a.ply", &[one]);
        let normals = read(text.as_bytes(), "a.ply")
            .expect("a mesh")
            .normals
            .expect("normals");
        assert_eq!(
            normals,
            [DVec3::Z, DVec3::Z, DVec3::ZERO, DVec3::Z, DVec3::Z],
            "{word}"
        );

        let text = OBJ.replace(
            "f 1 2 3 4",
            &format!("vn {word} 0 0\nvn 0 0 2\nf 1//2 2//2 3//1 4//2"),
        );
        is_read(text.as_bytes(), "a.obj", &[one]);
        let normals = read(text.as_bytes(), "a.obj")
            .expect("a mesh")
            .normals
            .expect("normals");
        assert_eq!(
            normals[..4],
            [DVec3::Z, DVec3::Z, DVec3::ZERO, DVec3::Z],
            "{word}"
        );
    }
    // Elements that no face has are not counted.
    is_read(format!("{OBJ}vn nan nan nan\n").as_bytes(), "a.obj", &[]);
}

/// Scanners write a vertex where they saw nothing.
#[test]
fn positions_that_no_face_has_may_be_anything() {
    for word in NOT_NUMBERS {
        let text = PLY
            .replace("vertex 5", "vertex 6")
            .replace("1 1 4\n", &format!("1 1 4\n{word} 0 {word}\n"));
        is_read(text.as_bytes(), "a.ply", &[]);
        let used = text.replace("3 0 1 4", "3 0 1 5");
        let error = read(used.as_bytes(), "a.ply")
            .expect_err("not finite")
            .to_string();
        assert_eq!(error, "vertex 5 (from 0) is not finite in single precision");
        is_read(format!("{OBJ}v {word} 0 0\n").as_bytes(), "a.obj", &[]);
    }
}

#[test]
fn normals_that_are_named_and_missing() {
    let rows = [
        ("f 1//1 2//2 3//3 4//4", 4),
        ("f 1//7 2//-3 3//0 4//18446744073", 4),
        ("vn 0 0 1\nf 1//1 2//1 3//1 4//2", 1),
    ];
    for (row, missing) in rows {
        let text = OBJ.replace("f 1 2 3 4", row);
        let warning = match missing {
            1 => "1 corner names a normal that the file lacks: the face's own normal is used there"
                .to_owned(),
            n => format!(
                "{n} corners name normals that the file lacks: the faces' own normals are used there"
            ),
        };
        is_read(text.as_bytes(), "a.obj", &[&warning]);
        assert_eq!(
            read(text.as_bytes(), "a.obj").expect("a mesh").normals,
            None
        );
    }
}

/// Strips of the Stanford scans: (0 1 2), (2 1 3); −1 begins another.
#[test]
fn triangle_strips() {
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
        0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 4\n10 0 1 3 2 -1 0 1 4 4 1\n";
    let mesh = read(text.as_bytes(), "a.ply").expect("strips");
    assert_eq!(mesh.triangles, [[0, 1, 3], [3, 1, 2], [0, 1, 4]]);
    // With faces, and for an index that does not exist.
    let both = text.replace(
        "element tristrips",
        "element face 1\nproperty list uchar int vertex_indices\nelement tristrips",
    );
    let both = both.replace("1 1 4\n10", "1 1 4\n3 0 2 4\n10");
    assert_eq!(
        read(both.as_bytes(), "a.ply").expect("both").triangles[0],
        [0, 2, 4]
    );
    assert_eq!(
        read(both.as_bytes(), "a.ply")
            .expect("both")
            .triangles
            .len(),
        4
    );
    let error = read(text.replace("-1 0", "-2 0").as_bytes(), "a.ply")
        .expect_err("no vertex")
        .to_string();
    assert_eq!(
        error,
        "face 0 (from 0) refers to vertex -2, but there are 5"
    );
    let short = text
        .replace("10 0 1 3 2 -1", "10 0 1 3 2 -1 0 1 -1")
        .replace("10 0", "13 0");
    let warnings = read(short.as_bytes(), "a.ply").expect("strips").warnings;
    assert_eq!(
        warnings,
        ["1 face with fewer than three corners is skipped"]
    );
}

/// Input that makes no triangles gives a warning where a person may miss it.
#[test]
fn statements_that_are_left_out() {
    let rows = [
        (
            "surf 0 1 0 1 1 2 3 4",
            "1 free-form curve or surface is skipped",
        ),
        (
            "curv 0 1 1 2\nsurf 0 1 0 1 1 2 3 4",
            "2 free-form curves and surfaces are skipped",
        ),
        (
            "call other.obj 1",
            "line 9 begins with the unknown word `call` and is skipped",
        ),
        (
            "F 1 2 3\nfrob",
            "2 lines begin with unknown words and are skipped; the first is line 9, `F`",
        ),
    ];
    for (row, warning) in rows {
        is_read(format!("{OBJ}{row}\n").as_bytes(), "a.obj", &[warning]);
    }
    // `fo` is the older word for a face; a name may end in a back slash.
    is_read(OBJ.replace("f 1 2 5", "fo 1 2 5").as_bytes(), "a.obj", &[]);
    is_read(
        OBJ.replace("f 1 2 5", "usemtl tex\\\nf 1 2 5").as_bytes(),
        "a.obj",
        &[],
    );
}

#[test]
fn a_file_that_contradicts_itself_has_its_culprit_named() {
    let rows = [
        (
            PLY.replace("2 2 0", "2 2 0 7"),
            "its line 13 has more than the 3 numbers that its header declares: `2 2 0 7`",
        ),
        (
            PLY.replace("0 0 0", "nan 0 0"),
            "vertex 0 (from 0) is not finite in single precision",
        ),
        (
            PLY.replace("2 0 0", "2 1e39 0"),
            "vertex 1 (from 0) is not finite in single precision",
        ),
    ];
    for (text, message) in rows {
        let error = read(text.as_bytes(), "a.ply").expect_err("refused");
        assert_eq!(error.to_string(), message);
    }
    // Of two lists of corners the first counts.
    let two = "property list uchar int vertex_index\nproperty list uchar int vertex_indices\nend";
    let text = PLY.replace("property list uchar int vertex_indices\nend", two);
    let text = text
        .replace("4 0 1 2 3", "4 0 1 2 3 0")
        .replace("3 0 1 4", "3 0 1 4 3 4 2 1");
    is_read(text.as_bytes(), "a.ply", &[]);
}
