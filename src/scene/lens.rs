//! `lens RADIUS FOCUS`: depth of field.

use super::Lens;
use super::arguments::Arguments;
use super::builder::Builder;
use super::field::{not_negative, positive};

/// `lens RADIUS FOCUS`
pub(super) fn lens(builder: &mut Builder, arguments: &mut Arguments) {
    let log = &mut builder.log;
    let fields = [
        not_negative("RADIUS", "the radius of the lens"),
        positive("FOCUS", "the focal distance"),
    ];
    let numbers = arguments.numbers(log, fields);
    let line = arguments.command().place.line;
    let lens = numbers.map(|[radius, focus]| Lens {
        line,
        radius: radius.value,
        focus: focus.value,
    });
    builder.lens.set(lens, arguments.command(), log);
}
