//! Figures as text, for both the table and the page.

use super::record::{CaseRecord, Held};

/// `0.25`, `6.2e3`, `∞`.
pub fn margin(x: f64) -> String {
    match x {
        x if x < 1000.0 => format!("{x:.2}"),
        x if x.is_finite() => small(x),
        _ => "∞".to_owned(),
    }
}

/// A relative difference: `0`, `3.1e-7`; `–` if no path carries light.
pub fn relative(x: Option<f64>) -> String {
    x.map_or("–".to_owned(), small)
}

/// `0`, `0.024 %`: two digits, because one path among millions must be visible.
pub fn share(part: u64, of: u64) -> String {
    let percent = 100.0 * part as f64 / of.max(1) as f64;
    match percent {
        0.0 => "0".to_owned(),
        p if p < 0.001 => format!("{p:.0e} %"),
        p => {
            let decimals = (1.0 - p.log10().floor()).clamp(0.0, 4.0) as usize;
            format!("{p:.decimals$} %")
        }
    }
}

fn small(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else {
        format!("{x:.1e}")
    }
}

/// `7`, `0.8340`, `2.2500`, `3.142e9`: all digits of possible counts, four or five of other numbers.
pub fn plain(x: f64) -> String {
    match x.fract() == 0.0 && x.abs() < 1e9 {
        true => format!("{x:.0}"),
        false => digits(x, 3),
    }
}

/// `0.8340`, `2.2500`, `3.14e9`: seven characters at most from 1e-9 to 1e10.
pub fn short(x: f64) -> String {
    digits(x, 2)
}

fn digits(x: f64, of_powers: usize) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        a if (1e-2..1e4).contains(&a) => {
            format!("{x:.*}", (4.0 - a.log10().floor().max(0.0)) as usize)
        }
        _ => format!("{x:.of_powers$e}"),
    }
}

/// The largest relative difference; 0 if there are paths and none differs.
pub fn worst(case: &CaseRecord) -> Option<f64> {
    case.worst.or(case.p99.map(|_| 0.0))
}

/// The value with the largest margin; `None` if all measured values are zero.
pub fn decisive(case: &CaseRecord) -> Option<&Held> {
    let larger = |a: &&Held, b: &&Held| a.margin.total_cmp(&b.margin);
    case.held.iter().max_by(larger).filter(|h| h.margin > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_fit_their_columns() {
        let texts = [
            0.0,
            1e-300,
            0.834_567,
            2.25,
            125.83,
            9999.9,
            12_345.0,
            3.141_592e9,
        ]
        .map(short);
        assert_eq!(
            texts,
            [
                "0",
                "1.00e-300",
                "0.8346",
                "2.2500",
                "125.83",
                "9999.9",
                "1.23e4",
                "3.14e9"
            ]
        );
        assert_eq!(
            [7.0, 2.25, 3.141_592e9, f64::NAN].map(plain),
            ["7", "2.2500", "3.142e9", "NaN"]
        );
        assert_eq!(
            [0.25, 6213.0, f64::INFINITY].map(margin),
            ["0.25", "6.2e3", "∞"]
        );
        assert_eq!(
            [None, Some(0.0), Some(3.14e-7)].map(relative),
            ["–", "0", "3.1e-7"]
        );
    }

    #[test]
    fn shares_have_two_digits() {
        let texts =
            [(0, 7), (1, 8192), (1, 100), (1, 3), (7, 7), (1, 1 << 20)].map(|(n, of)| share(n, of));
        assert_eq!(texts, ["0", "0.012 %", "1.0 %", "33 %", "100 %", "1e-4 %"]);
    }
}
