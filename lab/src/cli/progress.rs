//! Progress: a bar on a terminal, occasional lines elsewhere.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::caller::{Called, caller};
use super::streams::print_line;
use vkpt::render::Progress;
use vkpt::report::human::duration;

/// Time between two lines.
const PAUSE: Duration = Duration::from_secs(5);

/// The bar's steps; it moves by fractions.
const STEPS: u64 = 10_000;

/// Shows progress on stderr.
pub struct Display {
    start: Instant,
    form: Form,
}

enum Form {
    Silent,
    /// Of a program that calls.
    Caller(Called),
    Bar(ProgressBar),
    Lines {
        last: Instant,
    },
}

impl Display {
    /// The form that suits stderr; silent if `quiet`.
    pub fn new(quiet: bool) -> Self {
        let start = Instant::now();
        let form = match caller() {
            _ if quiet => Form::Silent,
            Some(by) => Form::Caller(by),
            None if std::io::stderr().is_terminal() => Form::Bar(bar()),
            None => Form::Lines { last: start },
        };
        Self { start, form }
    }

    /// Shows the progress of the rendering.
    pub fn update(&mut self, progress: Progress) {
        let elapsed = self.start.elapsed();
        self.show(progress.fraction, || of_rendering(&progress, elapsed));
    }

    /// Shows the progress of splitting the picture's light by classes of paths.
    pub fn splitting(&mut self, progress: Progress) {
        let elapsed = self.start.elapsed();
        self.show(progress.fraction, || {
            format!("light by class, {}", of_rendering(&progress, elapsed))
        });
    }

    /// Shows which case is about to run after `done` of `of`.
    pub fn case(&mut self, done: usize, of: usize, name: &str) {
        self.show(done as f64 / of as f64, || {
            format!("case {} of {of}: {name}", done + 1)
        });
    }

    /// Shows the part of all work that is done, in [0, 1], and the words beside the bar.
    pub fn show(&mut self, fraction: f64, words: impl Fn() -> String) {
        match &mut self.form {
            Form::Silent => {}
            Form::Caller(by) => by.caller.borrow_mut().progress(fraction, &words),
            Form::Bar(bar) => {
                bar.set_message(words());
                bar.set_position((fraction * STEPS as f64) as u64);
            }
            Form::Lines { last } if last.elapsed() >= PAUSE => {
                *last = Instant::now();
                print_line(format!("{:.0} %, {}", (100.0 * fraction).floor(), words()));
            }
            Form::Lines { .. } => {}
        }
    }

    /// Clears the line for what follows.
    pub fn finish(&mut self) {
        if let Form::Bar(bar) = &self.form {
            bar.finish_and_clear();
        }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::new(STEPS);
    // The template is a constant; if it is ever wrong, the crate's default style serves.
    if let Ok(style) = ProgressStyle::with_template("[{bar:30}] {percent:>3} %  {msg}") {
        bar.set_style(style.progress_chars("=> "));
    }
    bar
}

/// `31 of 256 samples per pixel, 1 min 20 s left`
fn of_rendering(progress: &Progress, elapsed: Duration) -> String {
    let Progress {
        samples_done,
        spp,
        fraction,
    } = *progress;
    // The maximum is omitted if only time or error end the rendering.
    let most = match spp < u32::MAX {
        true => format!(" of {spp}"),
        false => String::new(),
    };
    let left = match fraction > 0.0 {
        true => {
            let seconds = elapsed.as_secs_f64() * (1.0 - fraction) / fraction;
            format!(", {} left", duration(seconds))
        }
        false => String::new(),
    };
    format!("{samples_done}{most} samples per pixel{left}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rendering_reports_the_time_left() {
        let at = |samples_done, spp: u32, fraction| {
            let progress = Progress {
                samples_done,
                spp,
                fraction,
            };
            of_rendering(&progress, Duration::from_secs(30))
        };
        let rows = [
            (
                at(64, 256, 0.25),
                "64 of 256 samples per pixel, 1 min 30 s left",
            ),
            (at(0, 256, 0.0), "0 of 256 samples per pixel"),
            (
                at(255, 256, 0.999),
                "255 of 256 samples per pixel, 30 ms left",
            ),
            (at(7, u32::MAX, 0.5), "7 samples per pixel, 30.0 s left"),
        ];
        for (found, expected) in rows {
            assert_eq!(found, expected);
        }
    }
}
