//! Compares two lists of events, and shows where they diverge.

use std::fmt::{self, Display};

use super::event::Event;

/// Width of the left column: the longest of usual events.
const WIDTH: usize = 70;

/// Events of one path on the requested device and on the reference in f32, or on both references.
pub struct Trace {
    pub(super) names: [String; 2],
    pub(super) paths: [Vec<Event>; 2],
    /// Largest relative difference that counts as equal: 0 between two of f32.
    pub(super) tolerance: f64,
    /// Lines below them.
    pub(super) notes: Vec<String>,
}

impl Trace {
    /// Number of the first event that differs.
    fn divergence(&self) -> Option<usize> {
        let [a, b] = &self.paths;
        let differs = |i: &usize| match (a.get(*i), b.get(*i)) {
            (Some(a), Some(b)) => !a.agrees(b, self.tolerance),
            _ => true,
        };
        (0..a.len().max(b.len())).find(differs)
    }
}

impl Display for Trace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = &self.names;
        writeln!(f, "{a:<WIDTH$}  {b}")?;
        let divergence = self.divergence();
        for i in 0..self.paths[0].len().max(self.paths[1].len()) {
            let mark = if Some(i) == divergence {
                "── the paths diverge here ──\n"
            } else {
                ""
            };
            f.write_str(mark)?;
            let sides = [0, 1].map(|k| self.paths[k].get(i).map_or(Vec::new(), Event::lines));
            for k in 0..sides[0].len().max(sides[1].len()) {
                let [left, right] = [0, 1].map(|s| sides[s].get(k).map_or("", String::as_str));
                writeln!(f, "{}", format!("{left:<WIDTH$}  {right}").trim_end())?;
            }
        }
        for note in &self.notes {
            writeln!(f, "{note}")?;
        }
        match divergence {
            None => f.write_str("the two paths are the same"),
            Some(i) => write!(f, "the two paths diverge at event {}", i + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn event(x: f64) -> Event {
        Event {
            what: "vertex".into(),
            numbers: vec![("point", vec![1.0, x, 3.0])],
            rows: Vec::new(),
        }
    }

    fn trace(a: &[f64], b: &[f64], tolerance: f64) -> Trace {
        Trace {
            names: ["a".into(), "b".into()],
            paths: [a, b].map(|xs| xs.iter().map(|&x| event(x)).collect()),
            tolerance,
            notes: Vec::new(),
        }
    }

    #[test]
    fn equal_paths_are_the_same() {
        let text = trace(&[1.0, f64::NAN], &[1.0, f64::NAN], 0.0).to_string();
        assert!(text.ends_with("the two paths are the same"), "{text}");
        assert!(!text.contains("diverge here"), "{text}");
    }

    /// One ulp, a missing event, another kind of event.
    #[test]
    fn the_first_difference_is_marked() {
        let one_ulp = trace(&[1.0, 2.0, 5.0], &[1.0, 2.0 + 4e-16, 6.0], 0.0);
        let missing = trace(&[1.0, 2.0], &[1.0], 0.0);
        let mut other = trace(&[1.0, 2.0], &[1.0, 2.0], 0.0);
        other.paths[1][1].what = "escape".into();
        for planted in [one_ulp, missing, other] {
            let text = planted.to_string();
            assert!(text.ends_with("the two paths diverge at event 2"), "{text}");
            let before = text.split("── the paths diverge here ──").next();
            assert_eq!(
                before.map(|s| s.matches("point").count()),
                Some(2),
                "{text}"
            );
        }
    }

    #[test]
    fn the_tolerance_is_relative() {
        assert_eq!(trace(&[1000.0], &[1000.5], 1e-3).divergence(), None);
        assert_eq!(trace(&[1000.0], &[1002.0], 1e-3).divergence(), Some(0));
    }
}
