//! A reader of pbrt-v4's format, as https://pbrt.org/fileformat-v4 describes it: only of the statements and parameters that an
//! export may have.

mod plugins;
mod tokens;

use plugins::{check, words};
use tokens::{Token, tokens};

/// A statement.
#[derive(Debug, Default)]
pub struct Statement {
    pub directive: String,
    pub words: Vec<String>,
    /// Those of a transform.
    pub numbers: Vec<f64>,
    /// `type name`, and the values.
    pub parameters: Vec<(String, Vec<String>)>,
}

impl Statement {
    /// The name of the plugin: named things have it as a parameter.
    pub fn plugin(&self) -> &str {
        let kind = self
            .parameters
            .iter()
            .find(|(name, _)| name == "string type");
        kind.map_or(&self.words[0], |(_, values)| &values[0])
    }

    pub fn values(&self, parameter: &str) -> &[String] {
        let found = self.parameters.iter().find(|(name, _)| name == parameter);
        &found.unwrap_or_else(|| panic!("{parameter} is missing")).1
    }

    pub fn numbers_of(&self, parameter: &str) -> Vec<f64> {
        let values = self.values(parameter).iter();
        values
            .map(|value| value.parse().expect("a number"))
            .collect()
    }
}

/// The statements of a file; an error describes the mistake.
pub fn read(text: &str) -> Result<Vec<Statement>, String> {
    let mut statements: Vec<Statement> = Vec::new();
    let mut tokens = tokens(text)?.into_iter();
    while let Some(token) = tokens.next() {
        match (token, statements.last_mut()) {
            (Token::Bare(word), Some(last)) if word == "[" => {
                let values = until_bracket(&mut tokens)?;
                match last.parameters.last_mut() {
                    Some((_, given)) => given.extend(values),
                    None => last.numbers = values.iter().filter_map(|v| v.parse().ok()).collect(),
                }
            }
            (Token::Bare(word), _) => statements.push(Statement {
                directive: word,
                ..Statement::default()
            }),
            (Token::Quoted(word), Some(last)) => {
                match words(&last.directive).is_some_and(|most| last.words.len() < most) {
                    true => last.words.push(word),
                    false => last.parameters.push((word, Vec::new())),
                }
            }
            (token, None) => return Err(format!("{token:?} stands first")),
        }
    }
    statements.iter().try_for_each(check)?;
    named(&statements)?;
    Ok(statements)
}

fn until_bracket(tokens: &mut impl Iterator<Item = Token>) -> Result<Vec<String>, String> {
    let mut values = Vec::new();
    for token in tokens {
        match token {
            Token::Bare(word) if word == "]" => return Ok(values),
            Token::Quoted(word) | Token::Bare(word) => values.push(word),
        }
    }
    Err("a bracket is open".to_owned())
}

/// Named objects must exist, and attributes must end.
fn named(statements: &[Statement]) -> Result<(), String> {
    let made = |directive: &str, name: &str| {
        let mut made = statements.iter().filter(|s| s.directive == directive);
        name.is_empty() || made.any(|s| s.words[0] == name)
    };
    for statement in statements {
        let maker = match &*statement.directive {
            "NamedMaterial" => "MakeNamedMaterial",
            "MediumInterface" => "MakeNamedMedium",
            _ => continue,
        };
        if let Some(name) = statement.words.iter().find(|name| !made(maker, name)) {
            return Err(format!("there is no {name}"));
        }
    }
    let count = |name| statements.iter().filter(|s| s.directive == name).count();
    let [begun, ended] = ["AttributeBegin", "AttributeEnd"].map(count);
    match (begun == ended, count("WorldBegin")) {
        (true, 1) => Ok(()),
        _ => Err("a block has no end, or the world begins not once".to_owned()),
    }
}

#[test]
fn mistakes_are_found() {
    let whole = "Film \"rgb\" \"integer xresolution\" [ 8 ]\nWorldBegin\n\
                 MakeNamedMaterial \"m\" \"string type\" [ \"dielectric\" ] \"float eta\" [ 1.5 ]\n\
                 AttributeBegin\nNamedMaterial \"m\"\nShape \"sphere\" \"float radius\" [ 1 ]\nAttributeEnd\n";
    read(whole).expect("nothing is wrong");
    for (right, wrong) in [
        ("integer xresolution", "integer xresolutions"),
        ("integer xresolution", "float xresolution"),
        ("[ 8 ]", "[ 8.5 ]"),
        ("[ 8 ]", "[ 8 9 ]"),
        ("[ 8 ]", "[ 8"),
        ("dielectric", "dialectric"),
        ("float eta", "float ior"),
        ("NamedMaterial \"m\"\nS", "NamedMaterial \"n\"\nS"),
        ("AttributeEnd\n", ""),
        ("WorldBegin\n", ""),
        ("Shape", "Sphere"),
        ("\"sphere\"", "\"sphere"),
        ("[ 1 ]", "[ one ]"),
    ] {
        let text = whole.replacen(right, wrong, 1);
        assert!(text != whole && read(&text).is_err(), "{wrong} for {right}");
    }
}
