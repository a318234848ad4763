//! `camera ex ey ez  ry  ORIENTATION`, and the same line as other programs of the course write it.
//!
//! Student programs have put the quaternion before `ry`, written a quaternion without its `q`, and put the aperture and
//! focus of a lens before or after the orientation. Unambiguous lines are read with a warning; the rest are refused,
//! because a number in the wrong place gives another view.

use glam::{DQuat, DVec4};

use super::Camera;
use super::arguments::Arguments;
use super::builder::Builder;
use super::field::{Number, any, positive, vector};
use super::log::Log;
use super::number::prefix_length;
use super::orientation::{begins_rotation, orientation, quaternion, rotations};
use super::text::Token;

/// The order of the arguments after the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// `ry  ORIENTATION`
    RyFirst,
    /// `ORIENTATION  ry`
    RotationsFirst,
    /// `w x y z  ry`
    QuaternionFirst,
    /// `ry  w x y z`, with this many numbers between them.
    RyThenQuaternion(usize),
}

/// `camera ex ey ez  ry  ORIENTATION`
pub(super) fn camera(builder: &mut Builder, arguments: &mut Arguments) {
    let log = &mut builder.log;
    let eye = arguments.numbers(log, ["ex", "ey", "ez"].map(any));
    let seen = match order(arguments.rest()) {
        Some(order) => seen(order, arguments, log),
        None => {
            refuse(arguments, log);
            None
        }
    };
    let camera = eye.zip(seen).map(|(eye, (ry, orientation))| Camera {
        eye: vector(&eye),
        ry: ry.value,
        orientation,
    });
    let line = arguments.command().place.line;
    let camera = camera.map(|camera| (camera, line));
    builder.camera.set(camera, arguments.command(), log);
}

/// The intended order; `None` where no order fits, or several do.
fn order(rest: &[Token]) -> Option<Order> {
    let is_number = |token: &Token| prefix_length(token.text) > 0;
    let numbers = rest.iter().take_while(|token| is_number(token)).count();
    let rotations = rest.iter().any(|token| begins_rotation(token.text));
    match (numbers, rotations) {
        (0, true) if begins_rotation(rest[0].text) => Some(Order::RotationsFirst),
        // ry, and aperture and focus at most.
        (..=3, _) => Some(Order::RyFirst),
        (5..=7, false) if numbers == rest.len() => bare_quaternion(rest),
        _ => None,
    }
}

/// The one position where four of the numbers form a quaternion: those that programs write have norm 1, the course's
/// own .99964.
fn bare_quaternion(numbers: &[Token]) -> Option<Order> {
    let values: Vec<f64> = numbers.iter().filter_map(|token| value(token)).collect();
    let is_unit = |at: usize| {
        let q = values.get(at..at + 4).map(DVec4::from_slice);
        q.is_some_and(|q| (q.length() - 1.0).abs() < 0.01)
    };
    let orders = [
        (0, Order::QuaternionFirst),
        (1, Order::RyThenQuaternion(0)),
        (3, Order::RyThenQuaternion(2)),
    ];
    let mut fitting = orders.into_iter().filter(|(at, _)| is_unit(*at));
    match (fitting.next(), fitting.next()) {
        (Some((_, order)), None) => Some(order),
        _ => None,
    }
}

fn value(token: &Token) -> Option<f64> {
    token.text[..prefix_length(token.text)].parse().ok()
}

/// Reads ry and the orientation.
fn seen(order: Order, arguments: &mut Arguments, log: &mut Log) -> Option<(Number, DQuat)> {
    let start = arguments.rest().first().map(|token| token.place);
    let (ry, rotation) = match order {
        Order::RyFirst => {
            let ry = ry(arguments, log);
            return ry.zip(orientation(arguments, log));
        }
        Order::RotationsFirst => {
            let rotation = rotations(arguments, log);
            (ry(arguments, log), rotation)
        }
        Order::QuaternionFirst => {
            let rotation = quaternion(arguments, log, start?);
            (ry(arguments, log), rotation)
        }
        Order::RyThenQuaternion(between) => {
            let ry = ry(arguments, log);
            (0..between).for_each(|_| arguments.skip_one());
            let start = arguments.rest().first()?.place;
            (ry, quaternion(arguments, log, start))
        }
    };
    let read = match order {
        Order::RotationsFirst | Order::QuaternionFirst => "read as the orientation, then ry",
        _ => "read as ry, then the orientation as a quaternion w x y z",
    };
    let seen = ry.zip(rotation)?;
    let place = start?.to(arguments.last().place);
    let message = "the arguments of `camera` are in the order of another program".to_owned();
    log.warning(place, message, read)
        .help(format!("usage: {}", arguments.usage));
    // Perhaps aperture and focus.
    orientation(arguments, log)?;
    Some(seen)
}

fn ry(arguments: &mut Arguments, log: &mut Log) -> Option<Number> {
    arguments
        .numbers(log, [positive("ry", "ry")])
        .map(|[ry]| ry)
}

/// Reports that the meaning of the numbers is ambiguous.
fn refuse(arguments: &mut Arguments, log: &mut Log) {
    let rest = arguments.rest();
    if let (Some(first), Some(last)) = (rest.first(), rest.last()) {
        let place = first.place.to(last.place);
        let message = "the arguments of `camera` are in the order of another program".to_owned();
        log.error(
            place,
            message,
            "it is ambiguous which of these is ry and which is the orientation",
        )
        .help(format!("usage: {}", arguments.usage));
    }
    arguments.skip();
}
