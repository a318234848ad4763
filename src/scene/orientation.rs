//! ORIENTATION: a sequence of rotations, the rightmost of which acts first.

use glam::{DQuat, DVec3};

use super::arguments::Arguments;
use super::diagnostic::Place;
use super::field::{any, vector};
use super::log::Log;
use super::text::{Token, shorten};

const USAGE: &str =
    "an ORIENTATION is a sequence of x DEG, y DEG, z DEG, a DEG ax ay az and q w x y z";

/// The rotation that the rest of the line spells, of unit norm; the identity where it spells none.
///
/// Each step post-multiplies: q := q·r.
pub(super) fn orientation(arguments: &mut Arguments, log: &mut Log) -> Option<DQuat> {
    let mut q = Some(DQuat::IDENTITY);
    while let Some(token) = arguments.rest().first().copied() {
        let axis = match token.text {
            "x" => Some(DVec3::X),
            "y" => Some(DVec3::Y),
            "z" => Some(DVec3::Z),
            "a" | "q" => None,
            _ => {
                surplus(arguments, log);
                break;
            }
        };
        arguments.skip_one();
        let r = match (axis, token.text) {
            (Some(axis), _) => about_axis(arguments, log, axis),
            (None, "a") => about_any_axis(arguments, log, token),
            _ => quaternion(arguments, log, token),
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

/// The rest of `q w x y z`.
fn quaternion(arguments: &mut Arguments, log: &mut Log, command: Token<'_>) -> Option<DQuat> {
    let numbers = arguments.numbers(log, ["w", "x", "y", "z"].map(any))?;
    let [w, x, y, z] = numbers.map(|n| n.value);
    match glam::DVec4::new(x, y, z, w).try_normalize() {
        Some(unit) => Some(DQuat::from_vec4(unit)),
        None => no_direction(log, command.place.to(numbers[3].place), "a quaternion"),
    }
}

fn no_direction(log: &mut Log, place: Place, what: &str) -> Option<DQuat> {
    log.error(place, format!("{what} must not be zero"), "");
    None
}

/// Warns of what follows the orientation.
fn surplus(arguments: &mut Arguments, log: &mut Log) {
    if let (Some(first), Some(last)) = (arguments.rest().first(), arguments.rest().last()) {
        let message = format!("`{}` begins no rotation", shorten(first.text));
        log.warning(first.place.to(last.place), message, "left unread")
            .help(USAGE);
    }
    arguments.skip();
}
