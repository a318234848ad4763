//! The lines of a scene whose file has none, such as a glTF file: a message prints the lines that it names.

/// Line `number` of a text, from 1, with blanks collapsed.
pub fn line(text: &str, number: usize) -> Option<String> {
    let line = text.lines().nth(number.checked_sub(1)?)?;
    Some(line.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// The lines of `text` that `message` names as `line 3` or `lines 3 and 4`, each once, as sentences.
pub fn named(text: &str, message: &str) -> Vec<String> {
    let words: Vec<&str> = message
        .split(|c: char| !c.is_ascii_alphanumeric())
        .filter(|word| !word.is_empty())
        .collect();
    let mut numbers: Vec<usize> = Vec::new();
    for (i, word) in words.iter().enumerate() {
        let named = match *word {
            "line" => &words[i + 1..words.len().min(i + 2)],
            "lines" => &words[i + 1..words.len().min(i + 4)],
            _ => &[],
        };
        numbers.extend(named.iter().filter_map(|word| word.parse::<usize>().ok()));
    }
    numbers.sort_unstable();
    numbers.dedup();
    let explained = |number: usize| Some(format!("line {number} is `{}`", line(text, number)?));
    numbers.into_iter().filter_map(explained).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_found_by_their_numbers() {
        let text = "a\nb  c\nd\n";
        let found = |message| named(text, message);
        assert_eq!(found("line 2: x"), ["line 2 is `b c`"]);
        let both = ["line 1 is `a`", "line 3 is `d`"];
        assert_eq!(found("of lines 3 and 1 overlap"), both);
        assert_eq!(found("(box of line 3)\nline 1, line 1"), both);
        assert_eq!(found("line 0, line 4, 2 lines, line"), [""; 0]);
    }
}
