//! The numbers that commands take: their names and legal values.

use glam::DVec3;

use super::diagnostic::Place;
use super::log::Log;

/// A finite number and its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number {
    pub value: f64,
    pub place: Place,
}

/// Three numbers as a vector.
pub(super) fn vector(numbers: &[Number]) -> DVec3 {
    DVec3::new(numbers[0].value, numbers[1].value, numbers[2].value)
}

/// The legal values of a finite number.
#[derive(Clone, Copy, Debug)]
enum Legal {
    Any,
    NotZero,
    NotNegative,
    /// Positive in single precision too, because the renderer divides by it.
    Positive,
    /// Not negative; above 1 it counts as 1.
    Share,
}

/// A numeric argument of a command.
#[derive(Clone, Copy, Debug)]
pub(super) struct Field {
    /// The name in the command's usage.
    pub name: &'static str,
    /// The name within a sentence.
    noun: &'static str,
    legal: Legal,
}

/// Any finite number.
pub(super) const fn any(name: &'static str) -> Field {
    Field {
        name,
        noun: name,
        legal: Legal::Any,
    }
}

/// Any number other than 0.
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

/// The three channels of a colour from 0 to 1; larger values are clamped.
pub(super) fn share(names: [&'static str; 3], noun: &'static str) -> [Field; 3] {
    names.map(|name| Field {
        name,
        noun,
        legal: Legal::Share,
    })
}

/// The three channels of a radiance.
pub(super) const RADIANCE: [Field; 3] = [
    not_negative("r", "radiance"),
    not_negative("g", "radiance"),
    not_negative("b", "radiance"),
];

impl Field {
    /// The number as it counts, clamped where necessary; an error if it is not legal.
    pub fn check(self, log: &mut Log, number: Number) -> Option<Number> {
        let (value, noun) = (number.value, self.noun);
        // The renderer computes in single precision.
        let single = value as f32;
        let wrong = match self.legal {
            Legal::NotZero if value == 0.0 => format!("{noun} must not be zero"),
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
