//! A deterministic automaton over the letters of paths, built by regex-automata.

use regex_automata::dfa::{Automaton as _, StartKind, dense};
use regex_automata::nfa::thompson;
use regex_automata::util::primitives::StateID;
use regex_automata::util::syntax;
use regex_automata::{Anchored, MatchKind};

use super::Letter;

/// Maximum memory for an automaton and for its construction: a pattern such as `E.*D.........L` doubles it with each
/// dot.
const LARGEST: usize = 1 << 20;

/// The state after the letters read so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct State(StateID);

/// Reads strings from the eye onwards.
#[derive(Debug)]
pub struct Automaton {
    dfa: dense::DFA<Vec<u32>>,
    begin: State,
}

impl Automaton {
    /// An automaton for a regular expression over the letters, which must match the whole string.
    pub fn new(expression: &str) -> Result<Self, &'static str> {
        let config = dense::Config::new()
            .start_kind(StartKind::Anchored)
            // All alternatives are followed to their end: none takes precedence, as it would in a search.
            .match_kind(MatchKind::All)
            .dfa_size_limit(Some(LARGEST))
            .determinize_size_limit(Some(LARGEST));
        let built = dense::Builder::new()
            .configure(config)
            .syntax(syntax::Config::new().unicode(false).utf8(false))
            .thompson(thompson::Config::new().nfa_size_limit(Some(LARGEST)))
            .build(expression);
        let dfa = built.map_err(|error| match error.is_size_limit_exceeded() {
            true => "it is too large",
            false => "its brackets or repetitions do not match",
        })?;
        let start = dfa.universal_start_state(Anchored::Yes);
        let start = start.ok_or("it looks beyond the path")?;
        let begin = State(dfa.next_state(start, b'E'));
        Ok(Self { dfa, begin })
    }

    pub fn begin(&self) -> State {
        self.begin
    }

    pub fn after(&self, State(state): State, letter: Letter) -> State {
        State(self.dfa.next_state(state, letter.byte()))
    }

    pub fn ends(&self, State(state): State) -> bool {
        // The automaton reports matches one step late.
        let end = self.dfa.next_eoi_state(self.dfa.next_state(state, b'L'));
        self.dfa.is_match_state(end)
    }

    /// Whether any path's string leads to a match.
    pub fn matches_any(&self) -> bool {
        let mut known = vec![self.begin];
        let mut next = 0;
        while let Some(&state) = known.get(next) {
            if self.ends(state) {
                return true;
            }
            for letter in Letter::ALL {
                let after = self.after(state, letter);
                if !known.contains(&after) {
                    known.push(after);
                }
            }
            next += 1;
        }
        false
    }
}
