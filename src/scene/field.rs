//! The numbers that commands take: what each is called, and which values are legal.

use glam::DVec3;

use super::diagnostic::Place;
use super::log::Log;

/// A finite number, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number {
    pub value: f64,
    pub place: Place,
}

/// The vector of three numbers.
pub(super) fn vector(numbers: &[Number]) -> DVec3 {
    DVec3::new(numbers[0].value, numbers[1].value, numbers[2].value)
}

/// Which values of a finite number are legal.
#[derive(Clone, Copy, Debug)]
enum Legal {
    Any,
    NotZero,
    NotNegative,
    /// In single precision too: the renderer divides by it.
    Positive,
    /// Not negative; above 1 it is taken as 1.
    Share,
}

/// A number that a command takes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Field {
    /// As the command's usage has it.
    pub name: &'static str,
    /// As a sentence has it.
    noun: &'static str,
    legal: Legal,
}

/// A number of any finite value.
pub(super) const fn any(name: &'static str) -> Field {
    Field {
        name,
        noun: name,
        legal: Legal::Any,
    }
}

/// A number other than 0.
pub(super) const fn not_zero(name: &'static str, noun: &'static str) -> Field {
    Field {
        name,
        noun,
        legal: Legal::NotZero,
    }
}

/// A number of 0 or more.
pub(super) const fn not_negative(name: &'static str, noun: &'static str) -> Field {
    Field {
        name,
        noun,
        legal: Legal::NotNegative,
    }
}

/// A number above 0.
pub(super) const fn positive(name: &'static str, noun: &'static str) -> Field {
    Field {
        name,
        noun,
        legal: Legal::Positive,
    }
}

/// The three channels of a colour of 0 to 1, clamped where they are above it.
pub(super) fn share(names: [&'static str; 3], noun: &'static str) -> [Field; 3] {
    names.map(|name| Field {
        name,
        noun,
        legal: Legal::Share,
    })
}

/// The three channels of a radiance.
pub(super) const RADIANCE: [Field; 3] = [
    not_negative("r", "a radiance"),
    not_negative("g", "a radiance"),
    not_negative("b", "a radiance"),
];

impl Field {
    /// The number as it counts; an error where it is not legal.
    pub fn check(self, log: &mut Log, number: Number) -> Option<Number> {
        let (value, noun) = (number.value, self.noun);
        // The renderer's own numbers are single.
        let single = value as f32;
        let wrong = match self.legal {
            Legal::NotZero if value == 0.0 => format!("{noun} is zero"),
            Legal::NotNegative | Legal::Share if value < 0.0 => {
                format!("{noun} must not be negative")
            }
            Legal::Positive if value <= 0.0 => format!("{noun} must be above 0"),
            Legal::NotZero | Legal::Positive if single == 0.0 => {
                format!("{noun} is zero in single precision")
            }
            Legal::Share if value > 1.0 => {
                log.warning(number.place, format!("{noun} is above 1"), "taken as 1");
                return Some(Number {
                    value: 1.0,
                    ..number
                });
            }
            _ => return Some(number),
        };
        log.error(number.place, wrong, "");
        None
    }
}
