//! Progress: a bar on a terminal, a line now and then elsewhere.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use crate::render::Progress;
use crate::report::human::duration;

/// Time between two plain lines.
const PAUSE: Duration = Duration::from_secs(5);

/// The bar's steps; it moves by fractions.
const STEPS: u64 = 10_000;

/// Shows progress on stderr.
pub enum Display {
    Silent,
    Bar(ProgressBar),
    Lines { start: Instant, last: Instant },
}

impl Display {
    /// What suits stderr; silent if asked to be `quiet`.
    pub fn new(quiet: bool) -> Self {
        let now = Instant::now();
        match () {
            () if quiet => Self::Silent,
            () if std::io::stderr().is_terminal() => Self::Bar(bar()),
            () => Self::Lines {
                start: now,
                last: now,
            },
        }
    }

    /// Shows how far the rendering is.
    pub fn update(&mut self, progress: Progress) {
        match self {
            Self::Silent => {}
            Self::Bar(bar) => {
                bar.set_message(format!(
                    "{}{}",
                    progress.samples_done,
                    most("/", progress.spp)
                ));
                bar.set_position((progress.fraction * STEPS as f64) as u64);
            }
            Self::Lines { start, last } => {
                if last.elapsed() >= PAUSE {
                    *last = Instant::now();
                    eprintln!("{}", line(&progress, start.elapsed()));
                }
            }
        }
    }

    /// Makes room for what comes after.
    pub fn finish(&mut self) {
        if let Self::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::new(STEPS);
    // The template is a constant; should it ever be wrong, the crate's own style shows as much.
    if let Ok(style) = ProgressStyle::with_template(
        "[{bar:30}] {percent:>3} %  {msg} samples per pixel, {eta} left",
    ) {
        bar.set_style(style.progress_chars("=> "));
    }
    bar.set_message("0");
    bar
}

/// `12 %, 31 of 256 samples per pixel, 1 min 20 s left`
fn line(progress: &Progress, elapsed: Duration) -> String {
    let Progress {
        samples_done,
        spp,
        fraction,
    } = *progress;
    let left = if fraction > 0.0 {
        format!(
            ", {} left",
            duration(elapsed.as_secs_f64() * (1.0 - fraction) / fraction)
        )
    } else {
        String::new()
    };
    format!(
        "{:.0} %, {samples_done}{} samples per pixel{left}",
        (100.0 * fraction).floor(),
        most(" of ", spp)
    )
}

/// The most samples there may be; nothing where time or error are to end the rendering alone.
fn most(before: &str, spp: u64) -> String {
    if spp < u32::MAX.into() {
        format!("{before}{spp}")
    } else {
        String::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_tells_what_is_left() {
        let at = |samples_done, fraction| {
            line(
                &Progress {
                    samples_done,
                    spp: 256,
                    fraction,
                },
                Duration::from_secs(30),
            )
        };
        assert_eq!(
            at(64, 0.25),
            "25 %, 64 of 256 samples per pixel, 1 min 30 s left"
        );
        assert_eq!(at(0, 0.0), "0 %, 0 of 256 samples per pixel");
        assert_eq!(
            at(255, 0.999),
            "99 %, 255 of 256 samples per pixel, 30 ms left"
        );
    }
}
