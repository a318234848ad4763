//! OBJ files that a generator writes in all spellings of the format: each is read as the mesh that was meant.

use std::collections::HashSet;
use std::path::Path;

use glam::DVec3;
use vkpt::scene::{MeshFile, parse_mesh};

use super::fuzz::Random;

/// A corner: which position, and which normal if it names one; from 0.
type Corner = (usize, Option<usize>);

/// The contents of a file.
struct Meant {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    faces: Vec<Vec<Corner>>,
}

impl Meant {
    fn any(random: &mut Random) -> Self {
        let mut vectors = |least: usize, most: usize| -> Vec<DVec3> {
            let count = least + random.below(most - least + 1);
            (0..count).map(|_| vector(random)).collect()
        };
        let (mut positions, normals) = (vectors(1, 6), vectors(0, 3));
        // Corners on a parabola, named in their order, make convex polygons, which are fans.
        let convex = random.below(2) == 0;
        if convex {
            let scale = 1.0 + random.below(9) as f64 / 8.0;
            for (k, p) in positions.iter_mut().enumerate() {
                *p = scale * DVec3::new(k as f64, 0.5, (k * k) as f64);
            }
        }
        let mut face = || {
            let with_normals = random.below(3);
            let count = if convex { 3 + random.below(4) } else { 3 };
            let mut corner = || {
                let named = match with_normals {
                    _ if normals.is_empty() => false,
                    2 => random.below(2) == 0,
                    all => all == 1,
                };
                let position = random.below(positions.len());
                (position, named.then(|| random.below(normals.len())))
            };
            let mut corners: Vec<Corner> = (0..count).map(|_| corner()).collect();
            if convex {
                corners.sort_by_key(|(position, _)| *position);
            }
            corners
        };
        let faces = (0..5).map(|_| face()).collect();
        Self {
            positions,
            normals,
            faces,
        }
    }

    /// The mesh: a vertex for each pair of position and normal, in the order in which the faces name them.
    fn mesh(&self) -> MeshFile {
        let mut pairs: Vec<Corner> = Vec::new();
        let mut triangles = Vec::new();
        for face in &self.faces {
            let smooth = face.iter().all(|(_, normal)| normal.is_some());
            let vertices: Vec<u32> = face
                .iter()
                .map(|(position, normal)| {
                    let pair = (*position, normal.filter(|_| smooth));
                    let known = pairs.iter().position(|known| *known == pair);
                    known.unwrap_or_else(|| {
                        pairs.push(pair);
                        pairs.len() - 1
                    }) as u32
                })
                .collect();
            for i in 2..vertices.len() {
                triangles.push([vertices[0], vertices[i - 1], vertices[i]]);
            }
        }
        let unit = |n: usize| self.normals[n].normalize_or_zero();
        let normals = pairs.iter().map(|(_, n)| n.map_or(DVec3::ZERO, unit));
        let smooth = pairs.iter().any(|(_, n)| n.is_some());
        let used = pairs.iter().filter_map(|(_, n)| *n);
        let zero: HashSet<usize> = used.filter(|n| unit(*n) == DVec3::ZERO).collect();
        let warning = match zero.len() {
            0 => None,
            1 => {
                Some("1 normal is zero or not finite: the faces' own normals are used there".into())
            }
            n => Some(format!(
                "{n} normals are zero or not finite: the faces' own normals are used there"
            )),
        };
        MeshFile {
            files: Vec::new(),
            positions: pairs.iter().map(|(p, _)| self.positions[*p]).collect(),
            normals: smooth.then(|| normals.collect()),
            triangles,
            warnings: warning.into_iter().collect(),
        }
    }

    /// The file: positions, normals and faces each in their order, among one another.
    fn text(&self, random: &mut Random) -> String {
        let (mut positions, mut normals, mut faces) = (0, 0, 0);
        let mut text = one_of(random, &["", "\u{feff}", "# a mesh\r\n", "\n"]).to_owned();
        loop {
            let words = match random.below(3) {
                0 if positions < self.positions.len() => {
                    positions += 1;
                    position(self.positions[positions - 1], random)
                }
                1 if normals < self.normals.len() => {
                    normals += 1;
                    let n = self.normals[normals - 1].to_array();
                    format!("vn {}", row(&n, random))
                }
                2 if faces < self.faces.len() => {
                    faces += 1;
                    let mut words = String::from("f");
                    for (p, n) in &self.faces[faces - 1] {
                        let p = index(*p, positions, random);
                        let n = n.map(|n| index(n, normals, random));
                        words += &format!(" {}", corner(p, n, random));
                    }
                    words
                }
                _ if positions + normals + faces == self.statements() => return text,
                _ => continue,
            };
            text += &line(&words, random);
        }
    }

    fn statements(&self) -> usize {
        self.positions.len() + self.normals.len() + self.faces.len()
    }
}

fn one_of<'a>(random: &mut Random, all: &[&'a str]) -> &'a str {
    all[random.below(all.len())]
}

fn vector(random: &mut Random) -> DVec3 {
    DVec3::from_array([(); 3].map(|()| number(random)))
}

/// A number that single precision represents: small and whole, with all digits of f64, or of any exponent.
fn number(random: &mut Random) -> f64 {
    let wide = f32::from_bits(random.next() as u32);
    match random.below(3) {
        0 => random.below(9) as f64 - 4.0,
        1 if wide.is_finite() => wide.into(),
        _ => random.next() as i64 as f64 / 1e18,
    }
}

/// A number with all of its digits.
fn written(x: f64, random: &mut Random) -> String {
    let plain = x.to_string();
    match (random.below(5), plain.strip_prefix("0.")) {
        (0, Some(digits)) => format!(".{digits}"),
        (0, None) if !plain.contains('.') => format!("{plain}."),
        (1, _) => format!("{x:+}"),
        (2, _) => format!("{x:e}"),
        (3, _) => format!("{x:+E}"),
        _ => plain,
    }
}

fn row(numbers: &[f64], random: &mut Random) -> String {
    let words: Vec<_> = numbers.iter().map(|x| written(*x, random)).collect();
    words.join(" ")
}

/// A position: alone, with a colour, or homogeneous.
fn position(p: DVec3, random: &mut Random) -> String {
    let plain = row(&p.to_array(), random);
    match random.below(4) {
        0 => format!("v {plain} 0.5 1 0"),
        1 => format!("v {plain} 1"),
        2 => format!("v {}", row(&(2.0 * p).extend(2.0).to_array(), random)),
        _ => format!("v {plain}"),
    }
}

/// An index, from 1; or, for a vertex above, perhaps counted back from there.
fn index(place: usize, above: usize, random: &mut Random) -> i64 {
    match place < above && random.below(2) == 0 {
        true => place as i64 - above as i64,
        false => place as i64 + 1,
    }
}

/// A corner, with a texture coordinate or without.
fn corner(position: i64, normal: Option<i64>, random: &mut Random) -> String {
    let texture = one_of(random, &["", "3", "-1"]);
    match (normal, random.below(3)) {
        (Some(normal), _) => format!("{position}/{texture}/{normal}"),
        (None, 0) => format!("{position}/{texture}/"),
        (None, 1) => format!("{position}/{texture}"),
        (None, _) => format!("{position}"),
    }
}

/// A line of words, with more or less between and behind them, perhaps on several lines.
fn line(words: &str, random: &mut Random) -> String {
    let mut line = one_of(random, &["", "", " ", "\t"]).to_owned();
    for (i, word) in words.split(' ').enumerate() {
        if i > 0 {
            line += one_of(random, &[" ", " ", "\t", "  ", "\\\n", " \\ # f 1\r\n\t"]);
        }
        line += word;
    }
    let behind = [
        "",
        "",
        " ",
        "\r",
        "# f 1 1 1",
        "\n#\\",
        "\nvt 0 1",
        "\no f 1 1 1",
        "\n\\\n",
    ];
    line + one_of(random, &behind) + "\n"
}

#[test]
fn each_is_read_as_it_was_meant() {
    let mut random = Random(5);
    for _ in 0..4000 {
        let meant = Meant::any(&mut random);
        let text = meant.text(&mut random);
        let read = parse_mesh(text.as_bytes(), Path::new("mesh.obj"));
        let read = read.unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert_eq!(read, meant.mesh(), "{text}");
    }
}
