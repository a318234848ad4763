//! The values of `--aov`.

use std::ffi::OsStr;
use std::fmt::{self, Display};

use clap::builder::TypedValueParser;
use clap::error::{ContextKind, ContextValue};
use clap::{Arg, Command, Error};

use super::values::choice;
use vkpt::film::{Aov, LIGHT};
use vkpt::path_class::PathClass;
use vkpt::report::names::Named;

/// An output in addition to the picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Beside {
    Aov(Aov),
    /// The light of a class of paths.
    Light(PathClass),
}

impl Beside {
    /// Whether it is a layer of the picture's own file.
    pub fn is_layer(&self) -> bool {
        match self {
            Self::Aov(aov) => aov.is_layer(),
            Self::Light(_) => true,
        }
    }
}

impl Display for Beside {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Aov(aov) => f.write_str(aov.name()),
            Self::Light(class) => write!(f, "{LIGHT}{}", class.text()),
        }
    }
}

/// All requested values, each once.
pub fn split(asked: &[Beside]) -> (Vec<Aov>, Vec<PathClass>) {
    let (mut aovs, mut classes) = (Vec::new(), Vec::new());
    for beside in asked {
        match beside {
            Beside::Aov(aov) if !aovs.contains(aov) => aovs.push(*aov),
            Beside::Light(class) if !classes.contains(class) => classes.push(class.clone()),
            _ => {}
        }
    }
    (aovs, classes)
}

/// The layer that `compare --layer` names: a class of paths may be written as for `--aov`.
pub fn layer(name: &str) -> String {
    let class = name.strip_prefix(LIGHT).map(PathClass::new);
    match class {
        Some(Ok(class)) => class.layer(),
        _ => name.to_owned(),
    }
}

/// Reads one of them.
#[derive(Clone)]
pub struct BesideParser;

impl TypedValueParser for BesideParser {
    type Value = Beside;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<Beside, Error> {
        let is_class = value.as_encoded_bytes().starts_with(LIGHT.as_bytes());
        if !is_class {
            let aov = choice::<Aov>().parse_ref(command, arg, value);
            return aov.map(Beside::Aov).map_err(with_classes);
        }
        let class = |text: &str| PathClass::new(text.strip_prefix(LIGHT).unwrap_or(text));
        class.parse_ref(command, arg, value).map(Beside::Light)
    }
}

/// Adds classes of paths to the names that the error lists.
fn with_classes(mut error: Error) -> Error {
    if let Some(ContextValue::Strings(names)) = error.get(ContextKind::ValidValue) {
        let classes = format!("{LIGHT}PATTERN");
        let names = names.iter().cloned().chain([classes]).collect();
        error.insert(ContextKind::ValidValue, ContextValue::Strings(names));
    }
    error
}
