//! The statements of an OBJ file that make a mesh.

use std::str::SplitWhitespace;

use glam::DVec3;

use crate::scene::mesh::left_out::LeftOut;
use crate::scene::mesh::text::float;

/// Statements that add no triangles, except those of curves and surfaces.
const SKIPPED: [&str; 37] = [
    "vt",
    "vp",
    "l",
    "p",
    "o",
    "g",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "cstype",
    "deg",
    "bmat",
    "step",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "bsp",
    "bzp",
    "cdc",
    "cdp",
    "res",
    "vc",
];

/// An error message about a line.
type Fault = String;

/// A corner of a face: indices into the lists of positions and normals, which may be filled by later lines.
pub(super) struct Corner {
    pub(super) position: u32,
    /// 0 if the corner names none. It may be beyond the end of the list.
    pub(super) normal: u32,
}

/// A face; its corners begin at the end of the previous face's.
pub(super) struct Face {
    /// Counted from 1.
    pub(super) line: usize,
    /// The end of its corners.
    pub(super) end: usize,
    /// Each of its corners names a normal.
    pub(super) smooth: bool,
}

/// Positions, normals and faces as in the file.
#[derive(Default)]
pub(super) struct Statements {
    pub(super) positions: Vec<DVec3>,
    pub(super) normals: Vec<DVec3>,
    pub(super) corners: Vec<Corner>,
    pub(super) faces: Vec<Face>,
    pub(super) left_out: LeftOut,
    /// The highest position, from 1, that a face names, and the line of that face.
    highest: (i64, usize),
}

impl Statements {
    /// Processes line `number`.
    pub(super) fn read(&mut self, number: usize, line: &str) -> Result<(), Fault> {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => self.positions.push(position(&mut words)?),
            Some("vn") => self.normals.push(vector(&mut words)?),
            Some("f" | "fo") => self.face(number, words)?,
            Some("curv" | "curv2" | "surf") => self.left_out.surfaces += 1,
            Some(word) if !SKIPPED.contains(&word) => self.left_out.unknown(number, word),
            _ => {}
        }
        Ok(())
    }

    /// Processes a face of corners `v`, `v/vt`, `v//vn`, `v/vt/vn`.
    fn face(&mut self, line: usize, corners: SplitWhitespace) -> Result<(), Fault> {
        if corners.clone().nth(2).is_none() {
            self.left_out.faces += 1;
            return Ok(());
        }
        let (mut smooth, mut understood) = (true, true);
        for corner in corners {
            let mut parts = corner.split('/');
            let position = self.position(parts.next().unwrap_or_default(), line)?;
            let texture = parts.next().unwrap_or_default();
            let normal = match parts.next() {
                None | Some("") => {
                    smooth = false;
                    0
                }
                Some(normal) => place(number(normal)?, self.normals.len()).unwrap_or(u32::MAX),
            };
            understood &= texture.is_empty() || texture.parse::<i64>().is_ok();
            understood &= parts.all(str::is_empty);
            self.corners.push(Corner { position, normal });
        }
        let end = self.corners.len();
        self.faces.push(Face { line, end, smooth });
        understood.then_some(()).ok_or_else(not_understood)
    }

    /// The index of the position that a corner names; whether it exists is checked at the end of the file.
    fn position(&mut self, text: &str, line: usize) -> Result<u32, Fault> {
        let index = number(text)?;
        let above = self.positions.len();
        let place = place(index, above).ok_or_else(|| out_of_range(index, above))?;
        self.highest = self.highest.max((i64::from(place) + 1, line));
        Ok(place)
    }

    /// Checks, at the end of the file, that the positions named by faces exist; the error has the line.
    pub(super) fn check_highest(&self) -> Result<(), (usize, Fault)> {
        let ((index, line), count) = (self.highest, self.positions.len());
        match index > count as i64 {
            true => Err((line, out_of_range(index, count))),
            false => Ok(()),
        }
    }

    /// How many of a face's corners name a missing normal.
    pub(super) fn without_normal(&self, corners: &[Corner]) -> usize {
        let is_missing = |corner: &&Corner| corner.normal as usize >= self.normals.len();
        corners.iter().filter(is_missing).count()
    }
}

/// The index, from 0, of an OBJ reference: references count from 1, or back from the last of those `above` if negative.
fn place(index: i64, above: usize) -> Option<u32> {
    let from_1 = match index {
        ..0 => index.checked_add(above as i64 + 1)?,
        0.. => index,
    };
    u32::try_from(from_1.checked_sub(1)?).ok()
}

/// x y z, or homogeneous coordinates x y z w; a colour after x y z is ignored.
fn position(words: &mut SplitWhitespace) -> Result<DVec3, Fault> {
    let position = vector(words)?;
    match (words.next(), words.count()) {
        (Some(w), 0) => match float(w.as_bytes()).ok_or_else(not_understood)? {
            0.0 => Err(not_understood()),
            w => Ok(position / w),
        },
        (Some(_), 1) => Err(not_understood()),
        _ => Ok(position),
    }
}

fn vector(words: &mut SplitWhitespace) -> Result<DVec3, Fault> {
    let mut component = || words.next().and_then(|word| float(word.as_bytes()));
    let mut component = || component().ok_or_else(not_understood);
    Ok(DVec3::new(component()?, component()?, component()?))
}

fn number(text: &str) -> Result<i64, Fault> {
    text.parse().map_err(|_| not_understood())
}

fn not_understood() -> Fault {
    "cannot be read".into()
}

fn out_of_range(index: i64, count: usize) -> Fault {
    format!("refers to vertex {index}, but there are {count}")
}
