//! Compares words and reports the differences.

use std::fmt::Write as _;

use super::words::{Row, Value};
use super::{GUARD, UNWRITTEN};

/// The differences of one twin.
pub struct Report {
    exact: bool,
    text: String,
    differing: usize,
    broken: bool,
}

/// Rows that a report shows.
const SHOWN: usize = 5;

impl Report {
    pub fn new(exact: bool) -> Self {
        Self {
            exact,
            text: String::new(),
            differing: 0,
            broken: false,
        }
    }

    /// Results that no device may give.
    pub fn broken(&mut self, what: &str) {
        self.broken = true;
        let _ = writeln!(self.text, "  {what}");
    }

    /// `words`: outputs and trailer.
    pub fn row(&mut self, row: &Row, values: &[Value], words: &[u32]) {
        let (words, trailer) = words.split_at(values.len());
        let mut lines = String::new();
        if trailer != [row.0.len() as u32, values.len() as u32, GUARD] {
            let [read, written, guard] = [trailer[0], trailer[1], trailer[2]];
            self.broken = true;
            let _ = writeln!(
                lines,
                "    the kernel read {read} words and wrote {written}, Rust {} and {}; guard {guard:#010x}",
                row.0.len(),
                values.len()
            );
        }
        let scale = values.iter().map(|v| v.magnitude()).fold(0.0, f32::max);
        for (i, (value, word)) in values.iter().zip(words).enumerate() {
            let same = if self.exact {
                equal(*value, *word)
            } else {
                near(*value, *word, scale)
            };
            if !same {
                let _ = writeln!(lines, "    output {i}: {}", difference(*value, *word));
            }
        }
        if !lines.is_empty() {
            self.differing += 1;
            if self.differing <= SHOWN {
                let _ = write!(self.text, "  .edge([{}])\n{lines}", row_text(row));
            }
        }
    }

    pub fn finish(self, name: &str, rows: usize) -> Result<(), String> {
        // Not exact: a comparison on the brink may turn out otherwise, rarely.
        let allowed = if self.exact { 0 } else { rows / 100 };
        if self.broken || self.differing > allowed {
            return Err(format!(
                "{name}: {} of {rows} rows differ\n{}",
                self.differing, self.text
            ));
        }
        Ok(())
    }
}

/// The same bits; a NaN equals any NaN that was written.
fn equal(value: Value, word: u32) -> bool {
    match value {
        Value::Uint(x) => x == word,
        Value::Float(x) if x.is_nan() => f32::from_bits(word).is_nan() && word != UNWRITTEN,
        Value::Float(x) => x.to_bits() == word,
    }
}

/// On devices that may round `÷` and `√` their own way: integers equal; floats within 1e-4 of their size, or within 1e-5 of
/// the row's largest output, which a difference of large numbers may lose. One row in a hundred may lie elsewhere.
fn near(value: Value, word: u32, scale: f32) -> bool {
    match value {
        Value::Float(x) if x.is_finite() => {
            let difference = (x - f32::from_bits(word)).abs();
            difference <= 1e-4 * x.abs() || difference <= 1e-5 * scale
        }
        value => equal(value, word),
    }
}

fn difference(value: Value, word: u32) -> String {
    match value {
        _ if word == UNWRITTEN => "not written".into(),
        Value::Uint(x) => format!("device {word:#010x} ({word}), Rust {x:#010x} ({x})"),
        Value::Float(x) => {
            let (bits, y) = (x.to_bits(), f32::from_bits(word));
            let ulps = (order(bits) - order(word)).abs();
            format!("device {word:#010x} ({y:e}), Rust {bits:#010x} ({x:e}), {ulps} ulps apart")
        }
    }
}

/// Neighbouring floats have neighbouring numbers.
fn order(bits: u32) -> i64 {
    let magnitude = i64::from(bits & 0x7fff_ffff);
    if bits >> 31 == 1 {
        -magnitude - 1
    } else {
        magnitude
    }
}

fn row_text(row: &Row) -> String {
    let word = |w: &u32| format!("{w:#010x} /* {:e} */", f32::from_bits(*w));
    let words: Vec<String> = row.0.iter().map(word).collect();
    words.join(", ")
}
