//! The integrator: paths from the eye, with vkpt's roulette where Mitsuba's is right.

use super::document::Node;
use crate::export::Subject;
use crate::export::seen::{absorbs, used};

/// `path` tests roulette from the third bounce on, as vkpt does.
const ROULETTE: i64 = 3;

/// Where vkpt ends long paths by roulette whatever the settings.
const LONG_PATH: i64 = 1000;

/// `volpathmis` where anything absorbs, whose weights hold all three channels; `path` elsewhere, which passes over media.
///
/// Roulette in `volpathmis` changes the density of the path but not that of connections, so that its weights add up to less
/// than 1: 0.5 % of the light is missing in `scenes/room.txt`. So there is none but for paths that may never end.
pub fn node(subject: &Subject) -> Node {
    let (kind, roulette) = match used(subject.prepared).any(absorbs) {
        true => ("volpathmis", LONG_PATH),
        false => ("path", ROULETTE),
    };
    // Mitsuba counts segments, vkpt bounces; −1 is no limit.
    let depth = subject.model.max_depth.map_or(-1, |n| i64::from(n) + 1);
    Node::plugin("integrator", kind)
        .integer("max_depth", depth)
        .integer("rr_depth", roulette)
}
