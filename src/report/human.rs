//! Durations, counts and probabilities for people.

/// A count in three digits: `7`, `999`, `1.23 k`, `45.6 M`, `789 G`.
pub fn count(n: f64) -> String {
    let mut scaled = n;
    for unit in ["", " k", " M", " G", " T"] {
        // 999.5 would round to a fourth digit: use the next unit.
        if scaled < 999.5 {
            let digits = if unit.is_empty() { 0 } else { decimals(scaled) };
            return format!("{scaled:.digits$}{unit}");
        }
        scaled /= 1000.0;
    }
    format!("{n:.2e}")
}

/// Decimals that make three digits of a number in [1, 999.5), and two of a smaller one.
fn decimals(n: f64) -> usize {
    match n {
        n if n < 9.995 => 2,
        n if n < 99.95 => 1,
        _ => 0,
    }
}

/// A duration: `0 ms`, `85 ms`, `1.23 s`, `59.9 s`, `1 min 00 s`, `2 h 05 min`.
pub fn duration(seconds: f64) -> String {
    if seconds < 0.9995 {
        return format!("{:.0} ms", 1000.0 * seconds.max(0.0));
    }
    if seconds < 59.95 {
        return format!("{seconds:.*} s", decimals(seconds));
    }
    let whole = seconds.round() as u64;
    let (minutes, rest) = (whole / 60, whole % 60);
    match minutes {
        0..60 => format!("{minutes} min {rest:02} s"),
        _ => format!("{} h {:02} min", minutes / 60, minutes % 60),
    }
}

/// `1 sample`, `2 samples`.
pub fn plural(n: u64, noun: &str) -> String {
    format!("{n} {noun}{}", if n == 1 { "" } else { "s" })
}

/// `1,234,567`
pub fn thousands(n: u64) -> String {
    let digits = n.to_string();
    let groups: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(|group| std::str::from_utf8(group).unwrap_or_default())
        .collect();
    groups.join(",")
}

/// A size in three digits: `512 B`, `1.25 KiB`, `20.0 MiB`.
pub fn bytes(n: u64) -> String {
    let mut scaled = n as f64;
    for unit in ["B", "KiB", "MiB", "GiB"] {
        // 999.5 would round to a fourth digit: use the next unit.
        if scaled < 999.5 {
            let digits = if unit == "B" { 0 } else { decimals(scaled) };
            return format!("{scaled:.digits$} {unit}");
        }
        scaled /= 1024.0;
    }
    format!("{scaled:.2} TiB")
}

/// A p-value with two digits: `p = 5.4e-10`; `p < 1e-307` if f64 cannot represent it with full precision.
pub fn p_value(p: f64) -> String {
    match p < f64::MIN_POSITIVE {
        true => "p < 1e-307".to_owned(),
        false => format!("p = {p:.1e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_have_three_digits() {
        let cases = [
            (0.0, "0"),
            (7.0, "7"),
            (999.0, "999"),
            (1000.0, "1.00 k"),
            (1234.0, "1.23 k"),
            (9_994.0, "9.99 k"),
            (9_996.0, "10.0 k"),
            (99_960.0, "100 k"),
            (999_499.0, "999 k"),
            (999_500.0, "1.00 M"),
            (45_600_000.0, "45.6 M"),
            (7.89e11, "789 G"),
            (1e18, "1.00e18"),
        ];
        for (n, text) in cases {
            assert_eq!(count(n), text);
        }
    }

    #[test]
    fn a_p_value_is_never_zero() {
        for (p, text) in [
            (0.05, "p = 5.0e-2"),
            (5.43e-10, "p = 5.4e-10"),
            (f64::MIN_POSITIVE, "p = 2.2e-308"),
            (f64::MIN_POSITIVE / 2.0, "p < 1e-307"),
            (0.0, "p < 1e-307"),
        ] {
            assert_eq!(p_value(p), text);
        }
    }

    #[test]
    fn durations_change_unit_without_a_gap() {
        let cases = [
            (0.0, "0 ms"),
            (0.000_4, "0 ms"),
            (0.0851, "85 ms"),
            (0.9994, "999 ms"),
            (0.9996, "1.00 s"),
            (1.234, "1.23 s"),
            (59.94, "59.9 s"),
            (59.96, "1 min 00 s"),
            (119.6, "2 min 00 s"),
            (3599.4, "59 min 59 s"),
            (3599.6, "1 h 00 min"),
            (7500.0, "2 h 05 min"),
            (360_000.0, "100 h 00 min"),
        ];
        for (seconds, text) in cases {
            assert_eq!(duration(seconds), text);
        }
    }

    #[test]
    fn sizes_have_three_digits() {
        let cases = [
            (0, "0 B"),
            (999, "999 B"),
            (1000, "0.98 KiB"),
            (1 << 20, "1.00 MiB"),
            (20 << 20, "20.0 MiB"),
            (5 << 40, "5.00 TiB"),
        ];
        for (n, text) in cases {
            assert_eq!(bytes(n), text);
        }
        assert_eq!(thousands(0), "0");
        assert_eq!(thousands(1_234_567), "1,234,567");
    }

    #[test]
    fn one_has_no_s() {
        assert_eq!(
            [
                plural(0, "sample"),
                plural(1, "sample"),
                plural(2, "sample")
            ],
            ["0 samples", "1 sample", "2 samples"]
        );
    }
}
