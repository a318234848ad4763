//! The share of a path's light that belongs to a class.

use glam::DVec3;

use super::surface::Surface;
use crate::path_class::{Letter, PathClass, State};

/// States of a class's automaton, and the weight of the strings that led there.
#[derive(Default)]
pub struct Shares {
    now: Vec<(State, DVec3)>,
    next: Vec<(State, DVec3)>,
}

impl Shares {
    /// The share of the path that meets these surfaces on the way from the eye to its light: the weight of those of its
    /// strings that belong to `class`, where a surface with two letters doubles the number of strings.
    pub fn of<'a>(
        &mut self,
        class: &PathClass,
        surfaces: impl Iterator<Item = &'a Surface>,
    ) -> DVec3 {
        self.now.clear();
        self.now.push((class.begin(), DVec3::ONE));
        for surface in surfaces {
            self.meet(class, *surface);
        }
        let ending = self.now.iter().filter(|(state, _)| class.ends(*state));
        ending.map(|(_, weight)| *weight).sum()
    }

    fn meet(&mut self, class: &PathClass, surface: Surface) {
        self.next.clear();
        for &(state, weight) in &self.now {
            let to = |letter| class.after(state, letter);
            match surface {
                Surface::Smooth(side) => add(&mut self.next, to(Letter::S(side)), weight),
                Surface::Rough { diffuse, side } => {
                    add(&mut self.next, to(Letter::D), weight * diffuse);
                    add(
                        &mut self.next,
                        to(Letter::G(side)),
                        weight * (1.0 - diffuse),
                    );
                }
            }
        }
        std::mem::swap(&mut self.now, &mut self.next);
    }
}

/// Merges strings that led to the same state.
fn add(states: &mut Vec<(State, DVec3)>, state: State, weight: DVec3) {
    if weight == DVec3::ZERO {
        return;
    }
    match states.iter_mut().find(|(known, _)| *known == state) {
        Some((_, sum)) => *sum += weight,
        None => states.push((state, weight)),
    }
}
