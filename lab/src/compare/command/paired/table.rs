//! The table of `compare --paired`.

use super::findings::{Findings, PAIRS};
use vkpt::metrics::paired::{Closeness, Comparison, Diverged, Verdict};
use vkpt::report::human::{p_value, thousands};

/// A label and a cell for each pair.
type Row = (&'static str, [String; PAIRS.len()]);

/// The table, and the command lines that trace the paths it singles out.
pub fn text(findings: &Findings) -> String {
    let mut text = table(&rows(&findings.pairs));
    let device = &findings.pairs[0];
    text += &format!(
        "\nGPU – cpu-f32: {} of {} paths equal to the bit\n",
        thousands(device.equal),
        thousands(device.paths)
    );
    for (i, pair) in findings.pairs.iter().enumerate() {
        let mut show = |what: &str, address| {
            if let Some(address) = address {
                let command = findings.command(i, address);
                text += &format!("{}, {what}: {command}\n", PAIRS[i]);
            }
        };
        show("the worst", pair.closeness.worst.map(|w| w.address));
        show("the first to diverge", pair.first_diverged);
    }
    text
}

fn rows(pairs: &[Comparison; PAIRS.len()]) -> Vec<Row> {
    let each = |f: &dyn Fn(&Comparison) -> String| pairs.each_ref().map(f);
    let quantile = |q| each(&|p| of_light(&p.closeness, |c| c.quantile(q)));
    let mean = |c| each(&|p| mean_difference(&p.diverged, c));
    vec![
        ("", PAIRS.map(str::to_owned)),
        ("paths", each(&|p| thousands(p.paths))),
        ("equal to the bit", each(&|p| percent(p.equal, p.paths))),
        ("stay together", each(&|p| percent(p.together, p.paths))),
        ("  carry light", each(&|p| thousands(p.closeness.lit))),
        ("  relative difference, median", quantile(0.5)),
        ("    99 % are below", quantile(0.99)),
        ("    the worst", each(&worst)),
        ("    at pixel, sample", each(&worst_place)),
        ("diverge", each(&|p| thousands(p.paths - p.together))),
        ("  share", each(&|p| percent(p.paths - p.together, p.paths))),
        ("  mean difference, red", mean(0)),
        ("    green", mean(1)),
        ("    blue", mean(2)),
        ("  biased?", each(&|p| verdict(&p.diverged))),
        ("NaN or infinite", each(&|p| thousands(p.broken))),
    ]
}

/// Right-aligned columns, as wide as their widest cell, three blanks between them.
fn table(rows: &[Row]) -> String {
    let width = |cell: &dyn Fn(&Row) -> usize| rows.iter().map(cell).max().unwrap_or(0);
    let first = width(&|(label, _)| label.chars().count());
    let widths: [usize; PAIRS.len()] =
        std::array::from_fn(|i| width(&|(_, cells)| cells[i].chars().count()));
    let line = |(label, cells): &Row| {
        let cells = cells.iter().zip(widths);
        let cells: String = cells.map(|(cell, w)| format!("   {cell:>w$}")).collect();
        format!("{label:<first$}{cells}\n")
    };
    rows.iter().map(line).collect()
}

/// A cell without a value.
const NONE: &str = "–";

fn of_light(closeness: &Closeness, f: impl Fn(&Closeness) -> Option<f64>) -> String {
    f(closeness).map_or(NONE.to_owned(), small)
}

fn worst(pair: &Comparison) -> String {
    let none = (pair.closeness.lit > 0).then_some(0.0);
    let difference = pair.closeness.worst.map(|w| w.difference);
    difference.or(none).map_or(NONE.to_owned(), small)
}

fn worst_place(pair: &Comparison) -> String {
    pair.closeness.worst.map_or(NONE.to_owned(), |w| {
        let [x, y] = w.address.pixel;
        format!("{x},{y}, {}", w.address.index)
    })
}

/// With its standard error.
fn mean_difference(diverged: &Diverged, channel: usize) -> String {
    let (mean, error) = (diverged.mean()[channel], diverged.standard_error()[channel]);
    match diverged.paths {
        0 => NONE.to_owned(),
        1 => small(mean),
        _ => format!("{} ± {}", small(mean), small(error)),
    }
}

fn verdict(diverged: &Diverged) -> String {
    match diverged.verdict() {
        Verdict::TooFew if diverged.paths == 0 => NONE.to_owned(),
        Verdict::TooFew => "too few paths".to_owned(),
        Verdict::Unbiased(p) => format!("no, p = {p:.2}"),
        Verdict::Biased(p) => format!("yes, {}", p_value(p)),
    }
}

/// `0`, `3.1e-7`.
fn small(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else {
        format!("{x:.1e}")
    }
}

/// `100 %` and `0 %` of all and none; else with two significant digits of the distance to 0 or 100: `99.9921 %`.
fn percent(part: u64, whole: u64) -> String {
    if whole == 0 {
        return NONE.to_owned();
    }
    let share = 100.0 * part as f64 / whole as f64;
    let rest = share.min(100.0 - share);
    let decimals = match rest {
        0.0 => 0,
        _ => (1.0 - rest.log10().floor()).max(0.0) as usize,
    };
    format!("{share:.decimals$} %")
}

#[cfg(test)]
mod tests {
    use super::*;
    use vkpt::sample::{Address, Path};

    #[test]
    fn numbers_have_the_digits_that_matter() {
        let cases = [0, 7, 999, 1000, 12_345, 7_680_000].map(thousands);
        assert_eq!(cases, ["0", "7", "999", "1,000", "12,345", "7,680,000"]);
        let cases = [
            (0, 9, "0 %"),
            (9, 9, "100 %"),
            (1, 2, "50 %"),
            (1_919_848, 1_920_000, "99.9921 %"),
            (1, 10_000_000, "0.000010 %"),
            (9_999_999, 10_000_000, "99.999990 %"),
            (0, 0, "–"),
        ];
        for (part, whole, text) in cases {
            assert_eq!(percent(part, whole), text);
        }
    }

    fn path(radiance: f64, signature: u32) -> Path {
        Path {
            radiance: [radiance; 3],
            signature,
        }
    }

    #[test]
    fn the_table_lines_up_and_outliers_have_a_command() {
        let mut pairs: [Comparison; 3] = Default::default();
        for (i, pair) in pairs.iter_mut().enumerate() {
            for index in 0..4 {
                let address = Address {
                    pixel: [12, 3],
                    index,
                };
                // The first pair is equal; of the others sample 2 is off and sample 3 diverges.
                let off = if i > 0 && index == 2 { 1.5 } else { 1.0 };
                let parts = u32::from(i > 0 && index == 3);
                pair.add(address, &path(1.0, 0), &path(off, parts));
            }
        }
        let findings = Findings {
            pairs,
            correctly_rounded: true,
            show: ["vkpt a.txt", "vkpt a.txt --device cpu-f64"].map(str::to_owned),
        };
        let text = text(&findings);
        assert_eq!(findings.failures(), Vec::<String>::new());
        let (table, rest) = text.split_once("\n\n").expect("a table and more");
        let widths: Vec<usize> = table.lines().map(|l| l.chars().count()).collect();
        assert!(
            widths.iter().all(|w| *w == widths[0] && *w <= 100),
            "{text}"
        );
        assert!(table.contains("12,3, 2"), "{text}");
        assert!(rest.starts_with("GPU – cpu-f32: 4 of 4 paths equal to the bit\n"));
        for line in [
            "GPU – cpu-f64, the worst: vkpt a.txt --device cpu-f64 --trace 12,3,2",
            "cpu-f32 – cpu-f64, the first to diverge: vkpt a.txt --device cpu-f64 --trace 12,3,3",
        ] {
            assert!(rest.lines().any(|l| l == line), "{text}");
        }
    }
}
