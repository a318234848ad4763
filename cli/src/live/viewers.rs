//! The viewers of a growing picture.

use std::sync::Arc;
use std::time::Instant;

use super::board::Board;
use super::pace::Pace;
use super::server::Server;
use super::snapshot::Snapshot;
use super::state::Phase;
use super::tev::Tev;
use vkpt::film::Film;
use vkpt::render::{ErrorAt, Outcome, Progress};

/// A page, a viewer, both or none. Without any, all methods do nothing.
#[derive(Debug, Default)]
pub struct Viewers {
    /// Place of the first pixel in the full picture.
    origin: [u32; 2],
    page: Option<(Arc<Board>, Server)>,
    tev: Option<Tev>,
    pace: Pace,
    /// Snapshots so far.
    count: u64,
}

impl Viewers {
    /// The viewers of a film whose first pixel is `origin` of the full picture.
    pub fn new(origin: [u32; 2], page: Option<(Arc<Board>, Server)>, tev: Option<Tev>) -> Self {
        Self {
            origin,
            page,
            tev,
            ..Self::default()
        }
    }

    fn board(&self) -> Option<&Board> {
        self.page.as_ref().map(|(board, _)| &**board)
    }

    /// Reports progress of the rendering.
    pub fn progress(&self, progress: Progress) {
        if let Some(board) = self.board() {
            board.report(progress);
        }
    }

    /// Reports a failed device.
    pub fn trouble(&self, words: &str) {
        if let Some(board) = self.board() {
            board.trouble(words.to_owned());
        }
    }

    /// After a slice of samples: shows the snapshot of `so_far`, if anybody waits for it and the pace allows.
    pub fn reached(&mut self, so_far: &dyn Fn() -> Outcome) {
        if self.pace.is_due() && self.is_wanted() {
            let start = Instant::now();
            let Outcome {
                film, spp, state, ..
            } = so_far();
            self.show(film, spp, state.errors);
            self.pace.made(start);
        }
    }

    /// All samples are done; files are written next.
    pub fn rendered(&mut self, outcome: &Outcome) {
        let anybody = self.page.is_some() || self.tev.is_some();
        if anybody && outcome.spp > 0 {
            let errors = outcome.state.errors.clone();
            self.show(outcome.film.clone(), outcome.spp, errors);
        }
        if let Some(board) = self.board() {
            board.enter(Phase::Writing);
        }
    }

    /// Nothing more will come, and all files are `written` or not: waits briefly until every viewer has the last picture.
    pub fn ended(self, written: bool) {
        if let Some(board) = self.board() {
            board.enter(if written { Phase::Ended } else { Phase::Failed });
            board.wait_for_tabs();
        }
        if let Some(tev) = self.tev {
            tev.finish();
        }
    }

    fn is_wanted(&self) -> bool {
        let by_page = self.board().is_some_and(Board::is_wanted);
        by_page || self.tev.as_ref().is_some_and(Tev::is_wanted)
    }

    fn show(&mut self, film: Film, samples: u32, errors: Vec<ErrorAt>) {
        self.count += 1;
        let snapshot = Arc::new(Snapshot {
            number: self.count,
            film,
            origin: self.origin,
            samples,
            errors,
        });
        if let Some(board) = self.board() {
            board.show(snapshot.clone());
        }
        if let Some(tev) = &self.tev {
            tev.show(snapshot);
        }
    }
}
