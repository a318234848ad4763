//! ORIENTATION: a sequence of rotations; the rightmost acts first.

use glam::{DQuat, DVec3};

use super::arguments::Arguments;
use super::diagnostic::Place;
use super::field::{any, vector};
use super::log::Log;
use super::number::prefix_length;
use super::text::{Token, shorten};

const USAGE: &str =
    "an ORIENTATION is a sequence of x DEG, y DEG, z DEG, a DEG ax ay az and q w x y z";

/// Whether `word` begins a rotation.
pub(super) fn begins_rotation(word: &str) -> bool {
    ["x", "y", "z", "a", "q"].contains(&word)
}

/// The rotation given by the rest of the line, of unit norm; the identity if there is none. Words that begin no
/// rotation are skipped one by one, as in the course's framework.
pub(super) fn orientation(arguments: &mut Arguments, log: &mut Log) -> Option<DQuat> {
    let mut q = rotations(arguments, log);
    while !arguments.rest().is_empty() {
        strays(arguments, log);
        q = q
            .zip(rotations(arguments, log))
            .map(|(q, r)| (q * r).normalize());
    }
    q
}

/// The next rotations on the line, as one. Each post-multiplies: q := q·r.
pub(super) fn rotations(arguments: &mut Arguments, log: &mut Log) -> Option<DQuat> {
    let mut q = Some(DQuat::IDENTITY);
    while let Some(token) = arguments.rest().first().copied() {
        let axis = match token.text {
            "x" => Some(DVec3::X),
            "y" => Some(DVec3::Y),
            "z" => Some(DVec3::Z),
            "a" | "q" => None,
            _ => break,
        };
        arguments.skip_one();
        let r = match (axis, token.text) {
            (Some(axis), _) => about_axis(arguments, log, axis),
            (None, "a") => about_any_axis(arguments, log, token),
            _ => quaternion(arguments, log, token.place),
        };
        q = q.zip(r).map(|(q, r)| (q * r).normalize());
    }
    q
}

/// The rest of `x DEG`, `y DEG` or `z DEG`.
fn about_axis(arguments: &mut Arguments, log: &mut Log, axis: DVec3) -> Option<DQuat> {
    let [degrees] = arguments.numbers(log, [any("DEG")])?;
    Some(DQuat::from_axis_angle(axis, degrees.value.to_radians()))
}

/// The rest of `a DEG ax ay az`.
fn about_any_axis(arguments: &mut Arguments, log: &mut Log, command: Token<'_>) -> Option<DQuat> {
    let [degrees, axis @ ..] = arguments.numbers(log, ["DEG", "ax", "ay", "az"].map(any))?;
    match vector(&axis).try_normalize() {
        Some(unit) => Some(DQuat::from_axis_angle(unit, degrees.value.to_radians())),
        None => no_direction(
            log,
            command.place.to(axis[2].place),
            "the axis of a rotation",
        ),
    }
}

/// The numbers w x y z of a quaternion; `start` is where it begins.
pub(super) fn quaternion(arguments: &mut Arguments, log: &mut Log, start: Place) -> Option<DQuat> {
    let numbers = arguments.numbers(log, ["w", "x", "y", "z"].map(any))?;
    let [w, x, y, z] = numbers.map(|n| n.value);
    match glam::DVec4::new(x, y, z, w).try_normalize() {
        Some(unit) => Some(DQuat::from_vec4(unit)),
        None => no_direction(log, start.to(numbers[3].place), "a quaternion"),
    }
}

fn no_direction(log: &mut Log, place: Place, what: &str) -> Option<DQuat> {
    log.error(place, format!("{what} must not be zero"), "");
    None
}

/// Skips to the next rotation, with a warning.
fn strays(arguments: &mut Arguments, log: &mut Log) {
    let rest = arguments.rest();
    let strays = rest.iter().take_while(|token| !begins_rotation(token.text));
    let strays: Vec<Token> = strays.copied().collect();
    let (Some(first), Some(last)) = (strays.first(), strays.last()) else {
        return;
    };
    let message = format!("`{}` is not a rotation", shorten(first.text));
    let warning = log.warning(first.place.to(last.place), message, "ignored");
    let is_number = |token: &Token| prefix_length(token.text) > 0;
    warning.help(match arguments.command().text {
        "camera" if strays.iter().all(is_number) => {
            "other programs have the aperture and focus of a lens there; vkpt has a separate line for them: lens RADIUS FOCUS"
        }
        _ => USAGE,
    });
    strays.iter().for_each(|_| arguments.skip_one());
}
