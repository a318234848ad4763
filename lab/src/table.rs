//! Rows of text in columns.

/// Characters of the widest line.
pub const WIDTH: usize = 100;

/// Rows with two blanks before each column, each as wide as its widest cell; right-aligned where `right` is set.
pub fn columns<const N: usize>(rows: &[[String; N]], right: [bool; N]) -> String {
    let width = |k: usize| rows.iter().map(|r| r[k].chars().count()).max().unwrap_or(0);
    let widths: [usize; N] = std::array::from_fn(width);
    let line = |row: &[String; N]| {
        let mut line = String::new();
        for (k, cell) in row.iter().enumerate() {
            let width = widths[k];
            line += &match right[k] {
                true => format!("  {cell:>width$}"),
                false => format!("  {cell:<width$}"),
            };
        }
        format!("{}\n", line.trim_end())
    };
    rows.iter().map(line).collect()
}

/// `before` and `text`, which wraps with a hanging indent where a line would be wider than [`WIDTH`].
pub fn hanging(before: &str, text: &str) -> String {
    let indent = before.chars().count();
    let (mut all, mut line) = (String::new(), before.to_owned());
    let mut empty = true;
    for word in text.split_whitespace() {
        if !empty && line.chars().count() + 1 + word.chars().count() > WIDTH {
            all += &format!("{line}\n");
            line = " ".repeat(indent);
            empty = true;
        }
        line += if empty { "" } else { " " };
        line += word;
        empty = false;
    }
    format!("{all}{}\n", line.trim_end())
}

/// The group of a row, unless the row above has the same.
pub fn once(groups: &[&'static str], row: usize) -> String {
    let repeated = row > 0 && groups[row - 1] == groups[row];
    if repeated { "" } else { groups[row] }.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up() {
        let rows = [["é", "7", "x"], ["abc", "1,234", ""]].map(|row| row.map(str::to_owned));
        let text = columns(&rows, [false, true, false]);
        assert_eq!(text, "  é        7  x\n  abc  1,234\n");
    }

    #[test]
    fn long_text_goes_on_below_itself() {
        let text = hanging("  ab  ", &"word ".repeat(30));
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 2);
        assert!(lines[0].starts_with("  ab  word") && lines[0].len() <= WIDTH);
        assert!(lines[1].starts_with("      word"));
        assert_eq!(text.matches("word").count(), 30);
        let long = "x".repeat(200);
        assert_eq!(hanging("a ", &long), format!("a {long}\n"));
        assert_eq!(hanging("a ", ""), "a\n");
    }

    #[test]
    fn a_group_is_named_once() {
        let groups = ["shape", "shape", "light"];
        assert_eq!([0, 1, 2].map(|i| once(&groups, i)), ["shape", "", "light"]);
    }
}
