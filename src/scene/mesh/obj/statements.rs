//! The statements of an OBJ file that make a mesh, as `tobj` gets to read them.
//!
//! That crate takes a line of three points for a triangle and gives a corner without a normal its neighbour's; it
//! computes with indices before it checks them, stops at texture coordinates and comments that it does not expect,
//! and tells no lines. So it reads a file through this, which hands on positions, normals and faces only, checks
//! the references, and keeps what was on which line.

use std::borrow::Cow;
use std::io;

const POSITION: usize = 0;
const NORMAL: usize = 1;
const KINDS: [&str; 2] = ["vertex", "normal"];

/// A face that was handed on.
pub(super) struct Face {
    /// From 1.
    pub(super) line: usize,
    /// Each of its corners names a normal.
    pub(super) smooth: bool,
}

/// A line, and what is wrong with it.
type Culprit = (usize, String);

/// The file as `tobj` reads it: a statement a line.
pub(super) struct Statements<'a> {
    /// What is not yet read, and the number of lines that are.
    rest: &'a [u8],
    read: usize,
    /// The statement handed on, of which `taken` bytes are read; and the line on which it begins.
    statement: String,
    taken: usize,
    line: usize,
    /// Positions and normals so far.
    counts: [usize; 2],
    /// The highest position and normal that a face names, and its line: they may stand further down.
    highest: [(usize, usize); 2],
    pub(super) faces: Vec<Face>,
    culprit: Option<Culprit>,
}

impl<'a> Statements<'a> {
    pub(super) fn new(file: &'a [u8]) -> Self {
        Self {
            rest: file.strip_prefix("\u{feff}".as_bytes()).unwrap_or(file),
            read: 0,
            statement: String::new(),
            taken: 0,
            line: 0,
            counts: [0; 2],
            highest: [(0, 0); 2],
            faces: Vec::new(),
            culprit: None,
        }
    }

    /// Where reading stopped, and why.
    pub(super) fn culprit(self) -> Culprit {
        self.culprit.unwrap_or_else(|| not_understood(self.line))
    }

    /// Goes on to the next statement; at the file's end it is empty.
    fn advance(&mut self) -> Result<(), Culprit> {
        self.taken = 0;
        self.statement.clear();
        loop {
            self.line = self.read + 1;
            let Some(text) = self.logical_line() else {
                return self.check_highest();
            };
            let mut words: Vec<&str> = text.split_whitespace().collect();
            match words.first() {
                Some(&"v") => {
                    self.counts[POSITION] += 1;
                    // v x y z r g b …: the colour goes.
                    if words.len() >= 7 {
                        words.truncate(4);
                    }
                }
                Some(&"vn") => self.counts[NORMAL] += 1,
                Some(&"f") => self.face(&words[1..])?,
                _ => continue,
            }
            self.statement = words.join(" ");
            self.statement.push('\n');
            return Ok(());
        }
    }

    /// The next line without its comment, with those that a `\` at its end joins to it.
    fn logical_line(&mut self) -> Option<String> {
        let mut text = String::new();
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|b| *b == b'\n');
            let (line, rest) = self
                .rest
                .split_at(end.map_or(self.rest.len(), |end| end + 1));
            (self.rest, self.read) = (rest, self.read + 1);
            let line: Cow<str> = String::from_utf8_lossy(line);
            let line = line.split('#').next().unwrap_or_default().trim();
            let Some(joined) = line.strip_suffix('\\') else {
                text.push_str(line);
                return Some(text);
            };
            text.push_str(joined);
            text.push(' ');
        }
        (!text.is_empty()).then_some(text)
    }

    /// Checks and notes a face of corners `v`, `v/vt`, `v//vn`, `v/vt/vn`.
    fn face(&mut self, corners: &[&str]) -> Result<(), Culprit> {
        if corners.len() < 3 {
            return Err((self.line, format!("is a face of {} corners", corners.len())));
        }
        let mut smooth = true;
        for corner in corners {
            let mut parts = corner.split('/');
            self.refer(POSITION, parts.next().unwrap_or_default())?;
            match parts.nth(1) {
                None | Some("") => smooth = false,
                Some(normal) => self.refer(NORMAL, normal)?,
            }
        }
        let line = self.line;
        self.faces.push(Face { line, smooth });
        Ok(())
    }

    /// Checks an index, counted from 1, or back from the last one above if it is negative.
    fn refer(&mut self, kind: usize, text: &str) -> Result<(), Culprit> {
        let index: i64 = text.parse().map_err(|_| not_understood(self.line))?;
        let above = self.counts[kind];
        match usize::try_from(index) {
            Ok(0) => Err(out_of_range(self.line, kind, index, above)),
            Ok(index) => {
                self.highest[kind] = self.highest[kind].max((index, self.line));
                Ok(())
            }
            Err(_) if index.unsigned_abs() <= above as u64 => Ok(()),
            Err(_) => Err(out_of_range(self.line, kind, index, above)),
        }
    }

    /// Checks, at the file's end, what the faces name.
    fn check_highest(&self) -> Result<(), Culprit> {
        for (kind, ((index, line), count)) in self.highest.iter().zip(self.counts).enumerate() {
            if *index > count {
                return Err(out_of_range(*line, kind, *index as i64, count));
            }
        }
        Ok(())
    }
}

fn not_understood(line: usize) -> Culprit {
    (line, "is not understood".into())
}

fn out_of_range(line: usize, kind: usize, index: i64, count: usize) -> Culprit {
    let name = KINDS[kind];
    (
        line,
        format!("refers to {name} {index}, and there are {count}"),
    )
}

impl io::BufRead for Statements<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.statement.len() {
            self.advance().map_err(|culprit| {
                self.culprit = Some(culprit);
                io::Error::from(io::ErrorKind::InvalidData)
            })?;
        }
        Ok(&self.statement.as_bytes()[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken += amount;
    }
}

impl io::Read for Statements<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let n = io::BufRead::fill_buf(self)?.read(buffer)?;
        io::BufRead::consume(self, n);
        Ok(n)
    }
}
