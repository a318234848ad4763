//! OBJ files, whole and broken.

use std::path::Path;

use glam::DVec3;
use vkpt::scene::{MeshError, MeshFile, parse_mesh};

fn read(text: &str) -> Result<MeshFile, MeshError> {
    parse_mesh(text.as_bytes(), Path::new("mesh.Obj"))
}

/// The corners of each triangle and, where there are normals, the corners' normals.
fn soup(mesh: &MeshFile) -> Vec<[(DVec3, Option<DVec3>); 3]> {
    let normal = |i: usize| mesh.normals.as_ref().map(|normals| normals[i]);
    let corner = |i: u32| (mesh.positions[i as usize], normal(i as usize));
    mesh.triangles.iter().map(|t| t.map(corner)).collect()
}

const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 1 1.5 0\nv 0 1 0\n";

#[test]
fn a_polygon_is_a_fan_and_positions_keep_f64() {
    let mesh = read("v 0 0 .1\nv 1. 0 0\nv +1 1.5e0 0\nv 0 1 -0.1\nf 1 2 3 4\n").expect("a square");
    let expected = MeshFile {
        files: Vec::new(),
        positions: vec![
            DVec3::new(0.0, 0.0, 0.1),
            DVec3::X,
            DVec3::new(1.0, 1.5, 0.0),
            DVec3::new(0.0, 1.0, -0.1),
        ],
        normals: None,
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        warnings: Vec::new(),
    };
    assert_eq!(mesh, expected);
}

/// Other statements that a file may contain, and the many ways of saying the same.
#[test]
fn ways_of_writing_a_square() {
    let plain = soup(&read(&format!("{CORNERS}f 1 2 3 4\n")).expect("a square"));
    let rows = [
        "f 1/7 2/7 3/7 4/7",
        "f 1// 2// 3// 4//",
        "f -4 -3 -2 -1\nv 9 9 9",
        "f 1 2 3 \\\n  4",
        "f 1 2 \\ # half of it\r\n\t3 4\r",
        "f 1 2 3\nf 1 3 4\n",
        "f\t1  2 3 4 # five six",
        "o half\nf 1 2 3\ng other\nusemtl blue\ns off\nf 1 3 4",
        "mtllib none.mtl\nusemtl\nvt 1\nvt nonsense\nvp 1 2\ncstype bezier\nf 1 2 3 4",
        "l 1 2 3\np 1\nl 1 2 3 4\nf 1 2 3 4",
        "vn 0 0 1\nf 1//1 2//1 3 4",
        "#f 1 2 3\n# C:\\models\\\nf 1 2 3 4",
        "f 1 2 3 4 \\",
    ];
    for row in rows {
        let mesh = read(&format!("{CORNERS}{row}")).expect(row);
        assert_eq!(soup(&mesh), plain, "{row}");
    }
    let first = format!("\u{feff}f 1 2 3 4\n{CORNERS}");
    assert_eq!(soup(&read(&first).expect("a square")), plain, "faces first");
    let coloured = CORNERS.replace('\n', " .5 1 0\n");
    let weighted = "v 0 0 0 2\nv 2 0 0 2\nv 1 1.5 0 1\nv 0 .5 0 .5\n";
    for corners in [&coloured, weighted] {
        let mesh = read(&format!("{corners}f 1 2 3 4")).expect(corners);
        assert_eq!(soup(&mesh), plain, "{corners}");
    }
}

#[test]
fn latin_1_in_comments_and_names_is_no_hindrance() {
    let mut bytes = b"# caf\xe9\no caf\xe9\n".to_vec();
    bytes.extend(format!("{CORNERS}f 1 2 3\n").bytes());
    let mesh = parse_mesh(&bytes, Path::new("mesh.obj")).expect("a triangle");
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
}

#[test]
fn a_face_has_normals_if_all_its_corners_do() {
    let text = format!(
        "{CORNERS}vn 0 0 2\nvn 0 -4 0\nvn 0 0 0\n\
         f 1//1 2//2 3//3\nf 1 3 4\nf 1//1 3//1 4\nf 2//-3 3/8/-2 4//-1\n"
    );
    let mesh = read(&text).expect("four triangles");
    let normals: Vec<_> = soup(&mesh)
        .iter()
        .map(|corners| corners.map(|(_, normal)| normal.expect("a normal")))
        .collect();
    let (up, down, none) = (DVec3::Z, DVec3::NEG_Y, DVec3::ZERO);
    assert_eq!(
        normals,
        [[up, down, none], [none; 3], [none; 3], [up, down, none]]
    );
    // A vertex for each pair of position and normal: three in each face but the third.
    assert_eq!(mesh.positions.len(), 9);
}

#[test]
fn mistakes_are_named_with_their_line() {
    let rows = [
        (
            "f 1 2 5",
            "its line 5 refers to vertex 5, but there are 4: `f 1 2 5`",
        ),
        (
            "f 1 2 0",
            "its line 5 refers to vertex 0, but there are 4: `f 1 2 0`",
        ),
        (
            "f -1 -2 -5\nv 0 0 0",
            "its line 5 refers to vertex -5, but there are 4: `f -1 -2 -5`",
        ),
        (
            "f 1 2 9223372036854775807",
            "its line 5 refers to vertex 9223372036854775807, but there are 4: `f 1 2 9223372036854775807`",
        ),
        (
            "f 1 2 -9223372036854775808",
            "its line 5 refers to vertex -9223372036854775808, but there are 4: `f 1 2 -9223372036854775808`",
        ),
        ("f 1 2 3.5", "its line 5 cannot be read: `f 1 2 3.5`"),
        (
            "f 1 2 99999999999999999999",
            "its line 5 cannot be read: `f 1 2 99999999999999999999`",
        ),
        ("f /1 /2 /3", "its line 5 cannot be read: `f /1 /2 /3`"),
        (
            "f 1/x 2/x 3/x",
            "its line 5 cannot be read: `f 1/x 2/x 3/x`",
        ),
        (
            "vn 0 0 1\nf 1/1/1/1 2 3",
            "its line 6 cannot be read: `f 1/1/1/1 2 3`",
        ),
        ("v 1 2\nf 1 2 3", "its line 5 cannot be read: `v 1 2`"),
        (
            "v 1 2 3 0\nf 1 2 3",
            "its line 5 cannot be read: `v 1 2 3 0`",
        ),
        (
            "v 1 2 3 .5 .5",
            "its line 5 cannot be read: `v 1 2 3 .5 .5`",
        ),
        ("v 1 2 x", "its line 5 cannot be read: `v 1 2 x`"),
        ("vn 1 2", "its line 5 cannot be read: `vn 1 2`"),
        (
            "v nan 0 0\nf 1 2 5",
            "its line 6 has a vertex that is not finite in single precision: `f 1 2 5`",
        ),
        (
            "v 0 1e39 0\nf 1 2 5",
            "its line 6 has a vertex that is not finite in single precision: `f 1 2 5`",
        ),
        (
            "v 1 1 1 1e-99\nf 1 2 5",
            "its line 6 has a vertex that is not finite in single precision: `f 1 2 5`",
        ),
        (
            "f 1 3 2 4",
            "its line 5 is a face that crosses itself, cut it into triangles: `f 1 3 2 4`",
        ),
        (
            "f 1 2",
            "it has no faces: 1 face with fewer than three corners is skipped",
        ),
        ("l 1 2 3", "it has no faces"),
        ("", "it has no faces"),
    ];
    for (row, message) in rows {
        match read(&format!("{CORNERS}{row}")) {
            Ok(mesh) => panic!("{row} read as {mesh:?}"),
            // Long lines are cut short in messages.
            Err(error) => {
                let words = error.to_string();
                let cut = words.strip_suffix("…`").unwrap_or(&words);
                assert!(message.starts_with(cut), "{row}: {words}");
            }
        }
    }
    let unknown = |word: &str| {
        format!("it has no faces: line 1 begins with the unknown word `{word}` and is skipped")
    };
    let rows = [
        (&b"\n"[..], "it has no faces".to_owned()),
        (b"#", "it has no faces".to_owned()),
        (b"\\", "it has no faces".to_owned()),
        (b"solid cube\n", unknown("solid")),
        (b"F 1 2 3\n", unknown("F")),
    ];
    for (bytes, words) in rows {
        let read = parse_mesh(bytes, Path::new("mesh.obj"));
        assert_eq!(read.expect_err("no mesh").to_string(), words);
    }
}

/// Lines are read from above; the targets of the faces are looked up at the end, the highest first.
#[test]
fn the_first_of_several_mistakes_is_named() {
    let rows = [
        (
            "f 1/x 2 0",
            "its line 5 refers to vertex 0, but there are 4",
        ),
        ("f 1 2 9\nv 1 x 1", "its line 6 cannot be read"),
        ("f 1 2 9\nf 1 2 0", "its line 6 refers to vertex 0"),
        (
            "f 1 2 9\nf 1 2 8",
            "its line 5 refers to vertex 9, but there are 4",
        ),
        (
            "f 1 2 9\nf 1 2 9\nv 0 0 0",
            "its line 6 refers to vertex 9, but there are 5",
        ),
        ("f 1 2 9\nf 1 3 2 4", "its line 5 refers to vertex 9"),
        (
            "v nan 0 0\nf 1 2 5\nf 1 2 6",
            "its line 7 refers to vertex 6",
        ),
        ("f 1 2 4294967297", "its line 5 refers to vertex 4294967297"),
        (
            "\nf 1 2 \\\n0\nf 1",
            "its line 6 refers to vertex 0, but there are 4: `f 1 2 \\`",
        ),
        ("vn 0x1 0 0", "its line 5 cannot be read"),
        ("v 1,5 0 0", "its line 5 cannot be read"),
        ("v 1_0 0 0", "its line 5 cannot be read"),
        ("v - 0 0", "its line 5 cannot be read"),
        ("v 1 1 1 x", "its line 5 cannot be read"),
    ];
    for (row, message) in rows {
        let error = read(&format!("{CORNERS}{row}")).expect_err(row);
        assert!(error.to_string().starts_with(message), "{row}: {error}");
    }
}

#[test]
fn damaged_files_never_panic() {
    let whole = format!(
        "# a mesh\n{CORNERS}vt 0 1\nvn 0 0 1\nvn 0 1e0 -2\no a\nf 1//1 2//2 3//-1\nf 1/1/1 3/1/1 \\\n4/1/1\nl 1 2\n"
    );
    read(&whole).expect("a mesh");
    let mut random = super::fuzz::Random(3);
    for round in 0..4000 {
        let mut bytes = whole.clone().into_bytes();
        if round % 4 == 0 {
            bytes.truncate(random.below(bytes.len()));
        }
        for _ in 0..random.below(5) {
            let at = random.below(bytes.len().max(1)).min(bytes.len());
            match random.below(3) {
                0 => bytes.insert(at, b"-0123456789/ \nvfnel\\#."[random.below(22)]),
                1 if at < bytes.len() => drop(bytes.remove(at)),
                _ if at < bytes.len() => bytes[at] = random.next() as u8,
                _ => {}
            }
        }
        if let Ok(mesh) = parse_mesh(&bytes, Path::new("mesh.obj")) {
            let vertices = mesh.positions.len() as u32;
            assert!(mesh.triangles.iter().flatten().all(|i| *i < vertices));
            assert!(mesh.positions.iter().all(|p| p.as_vec3().is_finite()));
            let normals = mesh.normals.unwrap_or_default();
            assert!(
                normals
                    .iter()
                    .all(|n| *n == DVec3::ZERO || n.is_normalized())
            );
        }
    }
}
