//! Numbers as a C++ stream reads them: the longest numeric prefix of the token.

/// Length in bytes of the longest prefix of `token` that is a decimal number: sign, digits with an optional point,
/// exponent. 0 if the token does not begin with a number.
pub(super) fn prefix_length(token: &str) -> usize {
    let bytes = token.as_bytes();
    let digits = |from: usize| {
        bytes[from..]
            .iter()
            .take_while(|b| b.is_ascii_digit())
            .count()
    };
    let sign = |at: usize| usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));

    let whole_at = sign(0);
    let whole = digits(whole_at);
    let mut end = whole_at + whole;
    if bytes.get(end) == Some(&b'.') {
        let fraction = digits(end + 1);
        if whole + fraction == 0 {
            return 0;
        }
        end += 1 + fraction;
    } else if whole == 0 {
        return 0;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let exponent_at = end + 1 + sign(end + 1);
        let exponent = digits(exponent_at.min(bytes.len()));
        if exponent > 0 {
            end = exponent_at + exponent;
        }
    }
    end
}

/// Whether `token` spells NaN or infinity, which a stream does not read but a person may mean.
pub(super) fn is_not_finite(token: &str) -> bool {
    let word = token.trim_start_matches(['+', '-']).to_ascii_lowercase();
    matches!(word.as_str(), "nan" | "inf" | "infinity")
        || word.starts_with("nan(")
        || word.starts_with("1.#")
}

#[cfg(test)]
mod tests {
    use super::prefix_length;

    #[test]
    fn the_longest_number_at_the_front_is_taken() {
        let rows = [
            ("1", 1),
            ("-1.5", 4),
            ("+.5", 3),
            ("5.", 2),
            ("1e3", 3),
            ("1E-3", 4),
            ("1.e+3", 5),
            ("2.900874b", 8),
            ("1e", 1),
            ("1e+", 1),
            ("1.5.2", 3),
            ("0x10", 1),
            ("1,2", 1),
            ("7é", 1),
            ("", 0),
            (".", 0),
            ("-", 0),
            ("-.e5", 0),
            ("e5", 0),
            ("b1", 0),
            ("nan", 0),
            ("-inf", 0),
        ];
        for (token, length) in rows {
            assert_eq!(prefix_length(token), length, "{token}");
            assert!(
                length == 0 || token[..length].parse::<f64>().is_ok(),
                "{token}"
            );
        }
    }
}
