//! The statements of an OBJ file that make a mesh.

use std::str::{FromStr, SplitWhitespace};

use glam::DVec3;

const POSITION: usize = 0;
const NORMAL: usize = 1;
const KINDS: [&str; 2] = ["vertex", "normal"];

/// What is wrong with a line.
type Fault = String;

/// A corner of a face: places in the lists of positions and normals, which may be filled further down.
pub(super) struct Corner {
    pub(super) position: u32,
    /// 0 where none is named.
    pub(super) normal: u32,
}

/// A face; its corners begin where those of the face before end.
pub(super) struct Face {
    /// From 1.
    pub(super) line: usize,
    /// The end of its corners.
    pub(super) end: usize,
    /// Each of its corners names a normal.
    pub(super) smooth: bool,
}

/// Positions, normals and faces as they stand in the file.
#[derive(Default)]
pub(super) struct Statements {
    pub(super) positions: Vec<DVec3>,
    pub(super) normals: Vec<DVec3>,
    pub(super) corners: Vec<Corner>,
    pub(super) faces: Vec<Face>,
    /// The highest position and normal, from 1, that a face names, and its line.
    highest: [(i64, usize); 2],
}

impl Statements {
    /// Takes up line `number`.
    pub(super) fn read(&mut self, number: usize, line: &str) -> Result<(), Fault> {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => self.positions.push(position(&mut words)?),
            Some("vn") => self.normals.push(vector(&mut words)?),
            Some("f") => self.face(number, words)?,
            _ => {}
        }
        Ok(())
    }

    /// Takes up a face of corners `v`, `v/vt`, `v//vn`, `v/vt/vn`.
    fn face(&mut self, line: usize, corners: SplitWhitespace) -> Result<(), Fault> {
        if corners.clone().nth(2).is_none() {
            return Err(format!("is a face of {} corners", corners.count()));
        }
        let (mut smooth, mut understood) = (true, true);
        for corner in corners {
            let mut parts = corner.split('/');
            let position = self.refer(POSITION, parts.next().unwrap_or_default(), line)?;
            let texture = parts.next().unwrap_or_default();
            let normal = match parts.next() {
                None | Some("") => {
                    smooth = false;
                    0
                }
                Some(normal) => self.refer(NORMAL, normal, line)?,
            };
            understood &= texture.is_empty() || texture.parse::<i64>().is_ok();
            understood &= parts.all(str::is_empty);
            self.corners.push(Corner { position, normal });
        }
        let end = self.corners.len();
        self.faces.push(Face { line, end, smooth });
        understood.then_some(()).ok_or_else(not_understood)
    }

    /// The place, from 0, that an index means: it counts from 1, or back from the last one above if it is negative.
    fn refer(&mut self, kind: usize, text: &str, line: usize) -> Result<u32, Fault> {
        let index: i64 = number(text)?;
        let above = self.count(kind);
        let from_1 = match index {
            ..0 => above as i64 + 1 + index,
            0.. => index,
        };
        if from_1 < 1 {
            return Err(out_of_range(kind, index, above));
        }
        self.highest[kind] = self.highest[kind].max((from_1, line));
        // What does not fit is refused at the file's end.
        Ok(u32::try_from(from_1 - 1).unwrap_or_default())
    }

    fn count(&self, kind: usize) -> usize {
        [self.positions.len(), self.normals.len()][kind]
    }

    /// Checks, at the file's end, what the faces name; an error has its line.
    pub(super) fn check_highest(&self) -> Result<(), (usize, Fault)> {
        for (kind, (index, line)) in self.highest.into_iter().enumerate() {
            let count = self.count(kind);
            if index > count.min(u32::MAX as usize) as i64 {
                return Err((line, out_of_range(kind, index, count)));
            }
        }
        Ok(())
    }
}

/// x y z, or homogeneous coordinates x y z w; a colour after x y z is ignored.
fn position(words: &mut SplitWhitespace) -> Result<DVec3, Fault> {
    let position = vector(words)?;
    match (words.next(), words.count()) {
        (Some(w), 0) => match number(w)? {
            0.0 => Err(not_understood()),
            w => Ok(position / w),
        },
        (Some(_), 1) => Err(not_understood()),
        _ => Ok(position),
    }
}

fn vector(words: &mut SplitWhitespace) -> Result<DVec3, Fault> {
    let mut component = || number(words.next().unwrap_or_default());
    Ok(DVec3::new(component()?, component()?, component()?))
}

fn number<T: FromStr>(text: &str) -> Result<T, Fault> {
    text.parse().map_err(|_| not_understood())
}

fn not_understood() -> Fault {
    "is not understood".into()
}

fn out_of_range(kind: usize, index: i64, count: usize) -> Fault {
    let name = KINDS[kind];
    format!("refers to {name} {index}, and there are {count}")
}
