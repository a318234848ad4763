//! Access to the words of surroundings, whose arrays may be split over several buffers.

use crate::kernel::scene::dispatch::Dispatch;
use crate::kernel::scene::{Binding, Parameters};

/// `surroundings_end(i)` and `surroundings_value(i)`: word i of all parts together. Every part except the last has as
/// many words as the first, a power of two.
pub fn words(parameters: &Parameters) -> String {
    let part = |name| {
        let parts = parameters
            .bindings
            .iter()
            .filter(move |b| b.name.starts_with(name));
        parts.collect::<Vec<_>>()
    };
    word("uint", "surroundings_end", &part("surroundings_ends"))
        + &word("float", "surroundings_value", &part("surroundings_values"))
}

fn word(ty: &str, name: &str, parts: &[&Binding]) -> String {
    let (selector, place) = match parts {
        [] | [_] => (String::new(), "i".to_owned()),
        [first, ..] => (
            format!("i >> {}u", first.count.trailing_zeros()),
            format!("i & {}u", first.count - 1),
        ),
    };
    let dispatch = Dispatch {
        result: ty,
        name,
        arguments: &[("uint", "i")],
        selector: &selector,
    };
    let member = |(k, part): (u32, &&Binding)| (k, format!("{}[{place}]", part.name));
    let members: Vec<_> = (0..).zip(parts).map(member).collect();
    dispatch.text(&members, &format!("{ty}(0)"))
}
