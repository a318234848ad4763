//! The results of a comparison of pictures, as a table for people.

use std::fmt::Write;

use vkpt::metrics::blocks::{ALPHA, Block, BlockTest};
use vkpt::metrics::{Errors, Trimmed};
use vkpt::report::human::p_value;

/// Pictures of one size, each compared with the same reference.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Name of the reference.
    pub reference: String,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Stops by which radiance is scaled for FLIP.
    pub exposure: f64,
    /// Pixels of a degree of the eye's field, for FLIP.
    pub pixels_per_degree: f64,
    pub tested: Vec<Tested>,
}

/// One picture compared with the reference.
#[derive(Clone, Debug)]
pub struct Tested {
    pub name: String,
    pub errors: Errors,
    pub flip: Trimmed,
    /// The z-test, or why it was skipped.
    pub z_test: Result<BlockTest, String>,
}

/// The comparison as text: a table of errors, then the z-tests.
pub fn comparison(comparison: &Comparison) -> String {
    let [width, height] = comparison.size;
    let mut text = format!(
        "compared with {}, {width}×{height} pixels\n\n",
        comparison.reference
    );
    text += &heads(&comparison.tested);
    for (name, of) in METRICS {
        text += &row(name, &comparison.tested, |t| pair(of(t)));
    }
    text += &row("mean R", &comparison.tested, |t| means(&t.errors, 0));
    text += &row("mean G", &comparison.tested, |t| means(&t.errors, 1));
    text += &row("mean B", &comparison.tested, |t| means(&t.errors, 2));
    // Writing to a String cannot fail.
    let _ = write!(
        text,
        "\nFLIP of the PNGs at exposure {}, {:.0} pixels per degree\n",
        comparison.exposure, comparison.pixels_per_degree
    );
    for tested in &comparison.tested {
        text += "\n";
        text += &z_test(tested);
    }
    text
}

/// Each metric's name, and a function that reads it.
type Metric = (&'static str, fn(&Tested) -> Trimmed);

const METRICS: [Metric; 5] = [
    ("MSE", |t| t.errors.mse),
    ("RMSE", |t| t.errors.rmse),
    ("relMSE", |t| t.errors.rel_mse),
    ("SMAPE", |t| t.errors.smape),
    ("FLIP", |t| t.flip),
];

/// Two columns for each picture, under its name.
fn heads(tested: &[Tested]) -> String {
    row("", tested, |t| [t.name.clone(), String::new()])
        + &row("", tested, |_| {
            ["all pixels", "without the worst 1 %"].map(str::to_owned)
        })
}

/// Widths of the columns of a picture.
const WIDTHS: [usize; 2] = [14, 23];

fn row(name: &str, tested: &[Tested], cells: impl Fn(&Tested) -> [String; 2]) -> String {
    let mut line = format!("{name:<8}");
    for t in tested {
        let [a, b] = cells(t);
        let [first, second] = WIDTHS;
        // A name that is longer than its columns shifts the following ones instead of being cut.
        let both = format!("{a:<first$}{b}");
        let width = first + second;
        let _ = write!(line, "{both:<width$} ");
    }
    line.truncate(line.trim_end().len());
    line + "\n"
}

fn pair(value: Trimmed) -> [String; 2] {
    [value.all, value.without_worst].map(number)
}

/// The picture's mean, and the reference's.
fn means(errors: &Errors, channel: usize) -> [String; 2] {
    [
        number(errors.test_mean[channel]),
        format!("reference {}", number(errors.reference_mean[channel])),
    ]
}

/// Five digits, with an exponent where the number is small or large.
fn number(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        0.01..1000.0 => format!("{x:.5}"),
        _ => format!("{x:.4e}"),
    }
}

fn z_test(tested: &Tested) -> String {
    let name = &tested.name;
    let test = match &tested.z_test {
        Ok(test) => test,
        Err(why) => return format!("{name}: z-test skipped: {why}\n"),
    };
    let (worst, tests) = (test.worst(), test.blocks().len());
    let mut text = match test.rejected() {
        0 => format!("{name}: the z-test passes"),
        n => format!("{name}: the z-test fails in {n} of {tests} tests"),
    };
    let _ = write!(
        text,
        ": means of {} blocks in 3 channels, α = {ALPHA} in all, {:.1e} each\n  {}\n",
        tests / 3,
        test.level(),
        describe(&worst)
    );
    if let Some([mean, deviation]) = test.spread() {
        let _ = writeln!(
            text,
            "  z has mean {mean:.2} and standard deviation {deviation:.2} (0 and 1 if the standard errors are honest)"
        );
    }
    text
}

fn describe(block: &Block) -> String {
    let [x, y] = block.origin;
    let [width, height] = block.size;
    let channel = ["red", "green", "blue"][block.channel];
    let [a, b] = block.means.map(number);
    format!(
        "worst: {channel} of the {width}×{height} pixels at {x},{y}: {a} against {b}, standard error {}, z = {:.2}, {}",
        number(block.stderr),
        block.z,
        p_value(block.p)
    )
}
