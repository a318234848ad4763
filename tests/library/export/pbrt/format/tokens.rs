//! A text → words, brackets, and quoted strings.

/// A token: in quotes, or not.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    Quoted(String),
    Bare(String),
}

pub fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let mut tokens = Vec::new();
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            _ if letter.is_whitespace() => {}
            '[' | ']' => tokens.push(Token::Bare(letter.into())),
            '"' => {
                let mut word = String::new();
                loop {
                    match letters.next() {
                        Some('"') => break,
                        Some('\\') => word.extend(letters.next()),
                        Some('\n') | None => return Err(format!("\"{word} has no end")),
                        Some(letter) => word.push(letter),
                    }
                }
                tokens.push(Token::Quoted(word));
            }
            _ => {
                let mut word = String::from(letter);
                let ends = |c: &char| c.is_whitespace() || "[]\"".contains(*c);
                while let Some(letter) = letters.next_if(|c| !ends(c)) {
                    word.push(letter);
                }
                tokens.push(Token::Bare(word));
            }
        }
    }
    Ok(tokens)
}
