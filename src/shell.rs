//! Quotes words for a shell.

/// Quotes a word, whatever it contains, so that a shell reads it unchanged.
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+=:,".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

/// Words separated by blanks, each quoted.
pub fn line<W: AsRef<str>>(words: impl IntoIterator<Item = W>) -> String {
    let quoted = words.into_iter().map(|word| quoted(word.as_ref()));
    quoted.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_that_a_shell_would_change_are_quoted() {
        let words = ["vkpt", "a b.txt", "--vary", "connect=mis,light", "it's", ""];
        assert_eq!(
            line(words),
            "vkpt 'a b.txt' --vary connect=mis,light 'it'\\''s' ''"
        );
        assert_eq!(quoted("$HOME"), "'$HOME'");
    }
}
