//! Classes of paths as Heckbert's strings: patterns, and the automaton that reads a path letter by letter.
//!
//! A path's string begins with E, the eye, has a letter for each surface that scatters, and ends with L, the light.
//! Heckbert, Adaptive Radiosity Textures for Bidirectional Ray Tracing, 1990, writes it in the opposite direction.

mod automaton;
mod pattern;

use std::sync::Arc;

use crate::film::LIGHT;
use automaton::Automaton;
pub use automaton::State;
pub use pattern::PatternError;

/// The scattering of a path's light at a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letter {
    /// Diffuse reflection, Kd.
    D,
    /// Rough, by a micro-normal.
    G(Side),
    /// Smooth: each direction has exactly one counterpart.
    S(Side),
}

/// The side of a surface on which the light of a path continues.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Reflected: the side that it came from.
    R,
    /// Transmitted.
    T,
}

impl Letter {
    pub const ALL: [Self; 5] = [
        Self::D,
        Self::G(Side::R),
        Self::G(Side::T),
        Self::S(Side::R),
        Self::S(Side::T),
    ];

    /// The side on which light continues.
    pub fn side(self) -> Side {
        match self {
            Self::D => Side::R,
            Self::G(side) | Self::S(side) => side,
        }
    }

    /// The byte that an automaton reads.
    fn byte(self) -> u8 {
        match self {
            Self::D => b'D',
            Self::G(Side::R) => b'G',
            Self::G(Side::T) => b'g',
            Self::S(Side::R) => b'S',
            Self::S(Side::T) => b's',
        }
    }
}

/// The paths whose whole strings match a pattern.
#[derive(Clone, Debug)]
pub struct PathClass {
    text: String,
    automaton: Arc<Automaton>,
}

impl PathClass {
    /// # Errors
    /// The pattern cannot be parsed, or no path matches it.
    pub fn new(text: &str) -> Result<Self, PatternError> {
        let expression = pattern::expression(text)?;
        let automaton = Automaton::new(&expression).map_err(|why| PatternError::new(text, why))?;
        match automaton.matches_any() {
            true => Ok(Self {
                text: text.to_owned(),
                automaton: Arc::new(automaton),
            }),
            false => Err(PatternError::new(text, "no path matches it")),
        }
    }

    /// The pattern.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The name of a layer in an EXR, where a dot separates a layer from its channels: `.` becomes `_`.
    pub fn layer(&self) -> String {
        format!("{LIGHT}{}", self.text.replace('.', "_"))
    }

    /// The state at the eye, before any surface.
    pub fn begin(&self) -> State {
        self.automaton.begin()
    }

    /// The state after one more surface on the way from the eye.
    pub fn after(&self, state: State, letter: Letter) -> State {
        self.automaton.after(state, letter)
    }

    /// Whether a path that reaches its light in this state belongs to the class.
    pub fn ends(&self, state: State) -> bool {
        self.automaton.ends(state)
    }

    /// Whether the path whose surfaces have these letters belongs to the class.
    pub fn has(&self, surfaces: &[Letter]) -> bool {
        let after = |state, &letter: &Letter| self.after(state, letter);
        self.ends(surfaces.iter().fold(self.begin(), after))
    }
}

impl PartialEq for PathClass {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}
