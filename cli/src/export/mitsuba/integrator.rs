//! The integrator: paths from the eye, with vkpt's roulette where Mitsuba's is correct.

use super::document::Node;
use crate::export::Subject;
use crate::export::seen::{absorbs, used};

/// `path` applies roulette from the third bounce on, like vkpt.
const ROULETTE: i64 = 3;

/// From this bounce on vkpt applies roulette at any settings.
const LONG_PATH: i64 = 1000;

/// `volpathmis` if any medium absorbs, because its weights combine all three channels; otherwise `path`, which ignores
/// media.
///
/// Roulette in `volpathmis` changes the density of the path but not that of connections, so that its weights add up to
/// less than 1: 0.5 % of the light is missing in `scenes/room.txt`. So it is used only for paths that may never end.
pub fn node(subject: &Subject) -> Node {
    let (kind, roulette) = match used(subject.prepared).any(absorbs) {
        true => ("volpathmis", LONG_PATH),
        false => ("path", ROULETTE),
    };
    // Mitsuba counts segments, vkpt bounces; −1 means no limit.
    let depth = subject.model.max_depth.map_or(-1, |n| i64::from(n) + 1);
    Node::plugin("integrator", kind)
        .integer("max_depth", depth)
        .integer("rr_depth", roulette)
}
