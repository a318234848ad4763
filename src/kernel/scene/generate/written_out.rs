//! Primitives that are tried one by one, without a loop.
//!
//! On a CPU each is read into its own variable before any branch: lavapipe of Mesa 22.3 reads a uniform behind a branch
//! lane by lane, at any index (`shaders/integrator/path/path_trace.comp`). A GPU reads it into scalar registers
//! anywhere, and would run out of them if all were read at once: radv spills 436 on `scenes/glass-table.txt`.

use crate::shape::{Description, ShapeKind, filled};

/// How the primitives of a kind are written out.
pub struct WrittenOut {
    kind: &'static Description,
    count: usize,
}

impl WrittenOut {
    /// The primitives of a kind, by their number.
    pub fn new(kind: ShapeKind, count: impl Fn(&str) -> usize) -> Self {
        let kind = kind.description();
        Self {
            kind,
            count: count(kind.array),
        }
    }

    /// The file with the test.
    pub fn file(&self) -> &'static str {
        self.kind.nearer_file
    }

    /// Declares the variables; an array cannot be empty.
    pub fn copies(&self) -> String {
        match self.count {
            0 => String::new(),
            count => format!("{} {}_values[{count}];\n", self.kind.ty, self.kind.name),
        }
    }

    /// Reads each primitive from its buffer.
    pub fn read(&self) -> String {
        let line = |i| format!("    {} = {};\n", self.copy(i), self.element(i));
        (0..self.count).map(line).collect()
    }

    /// Tries each: its copy, if they were `read_first`.
    pub fn test(&self, read_first: bool) -> String {
        let once = format!("{}_once", self.kind.name);
        let line = |i| {
            let primitive = match read_first {
                true => self.copy(i),
                false => self.element(i),
            };
            let places = [
                ("{once}", &once[..]),
                ("{best}", "best"),
                ("{x}", &primitive),
                ("{i}", &format!("{i}u")),
            ];
            format!("    best = {};\n", filled(self.kind.nearer, &places))
        };
        let before =
            (self.kind.once.iter()).map(|[ty, value]| format!("    {ty} {once} = {value};\n"));
        before.chain((0..self.count).map(line)).collect()
    }

    fn element(&self, i: usize) -> String {
        filled(self.kind.element, &[("{i}", &format!("{i}u"))])
    }

    fn copy(&self, i: usize) -> String {
        format!("{}_values[{i}u]", self.kind.name)
    }
}
