//! The size of the picture: `screen`.

use super::Screen;
use super::arguments::Arguments;
use super::builder::Builder;
use super::field::{Number, any};
use super::log::Log;

/// Longest side of a picture, in pixels.
pub const LARGEST_SIDE: u32 = 16384;

/// `screen W H`
pub(super) fn screen(builder: &mut Builder, arguments: &mut Arguments) {
    let log = &mut builder.log;
    let screen = arguments
        .numbers(log, ["W", "H"].map(any))
        .and_then(|[width, height]| {
            let (width, height) = (side(log, width, "width"), side(log, height, "height"));
            Some(Screen {
                width: width?,
                height: height?,
            })
        });
    builder.screen.set(screen, arguments.command(), log);
}

/// A number of pixels; an error if it is not one. `what` names it.
fn side(log: &mut Log, number: Number, what: &str) -> Option<u32> {
    let value = number.value;
    let wrong = if value.fract() != 0.0 || value < 1.0 {
        format!("the {what} must be a whole number of pixels above 0")
    } else if value > f64::from(LARGEST_SIDE) {
        format!("the {what} must be at most {LARGEST_SIDE} pixels")
    } else {
        return Some(value as u32);
    };
    log.error(number.place, wrong, "");
    None
}
