//! The board between the rendering, which writes to it and continues, and the server, whose tabs read it.

use std::hash::{BuildHasher, RandomState};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::clock::Clock;
use super::gate::Asked;
use super::snapshot::Snapshot;
use super::state::{ErrorState, Phase, PictureState, State};
use super::tabs::Tabs;
use vkpt::render::Progress;

/// The longest wait at the end for tabs to get the last picture.
const PATIENCE: Duration = Duration::from_millis(1500);

/// The state to show. Its lock is held only while a few words are copied.
#[derive(Debug)]
pub struct Board {
    /// The name of the rendering.
    pub title: String,
    /// Distinguishes this rendering from a later one at the same port.
    run: u32,
    /// Set once somebody stops the rendering early.
    stop: Arc<AtomicBool>,
    shown: Mutex<Shown>,
    asked: Condvar,
}

#[derive(Debug)]
struct Shown {
    began: Instant,
    clock: Clock,
    phase: Phase,
    trouble: Option<String>,
    snapshot: Option<Arc<Snapshot>>,
    /// Whether a tab has the newest snapshot and waits for another.
    wanted: bool,
    tabs: Tabs,
}

impl Board {
    /// An empty board. Time starts now.
    pub fn new(title: String, stop: Arc<AtomicBool>) -> Self {
        let shown = Shown {
            began: Instant::now(),
            clock: Clock::default(),
            phase: Phase::Rendering,
            trouble: None,
            snapshot: None,
            wanted: false,
            tabs: Tabs::default(),
        };
        Self {
            run: RandomState::new().hash_one(&title) as u32,
            title,
            stop,
            shown: Mutex::new(shown),
            asked: Condvar::new(),
        }
    }

    fn shown(&self) -> MutexGuard<'_, Shown> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Reports progress of the rendering.
    pub fn report(&self, progress: Progress) {
        self.shown().clock.report(progress);
    }

    /// Reports a failed device.
    pub fn trouble(&self, words: String) {
        self.shown().trouble = Some(words);
    }

    /// Whether a tab waits for a newer snapshot.
    pub fn is_wanted(&self) -> bool {
        self.shown().wanted
    }

    /// A newer snapshot.
    pub fn show(&self, snapshot: Arc<Snapshot>) {
        let mut shown = self.shown();
        shown.snapshot = Some(snapshot);
        shown.wanted = false;
    }

    /// Enters a phase of the rendering.
    pub fn enter(&self, phase: Phase) {
        self.shown().phase = phase;
    }

    /// Waits briefly until every open tab has everything.
    pub fn wait_for_tabs(&self) {
        // The program ends next, whatever the result.
        let _ = self
            .asked
            .wait_timeout_while(self.shown(), PATIENCE, |shown| shown.tabs.wait());
    }

    /// Stops the rendering early.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// The newest snapshot.
    pub fn snapshot(&self) -> Option<Arc<Snapshot>> {
        self.shown().snapshot.clone()
    }

    /// The answer to a tab's question.
    pub fn answer(&self, asked: Asked) -> State {
        let mut shown = self.shown();
        let newest = shown.snapshot.as_ref().map_or(0, |s| s.number);
        let is_up_to_date = asked.has == newest;
        shown.wanted |= is_up_to_date;
        if let Some(tab) = asked.tab {
            // This answer may be lost when the program ends: the tab must confirm it.
            let has_all = is_up_to_date && asked.knows_end && shown.phase.is_last();
            shown.tabs.asks(tab, has_all);
        }
        self.asked.notify_all();
        self.state(&shown)
    }

    fn state(&self, shown: &Shown) -> State {
        let progress = shown.clock.progress();
        let snapshot = shown.snapshot.as_deref();
        let errors = snapshot.map_or(&[][..], |s| &s.errors);
        State {
            run: self.run,
            phase: shown.phase,
            stopping: self.stop.load(Ordering::Relaxed),
            samples: progress.map_or(0, |p| p.samples_done),
            spp: progress.map(|p| p.spp).filter(|&spp| spp < u32::MAX),
            fraction: progress.map_or(0.0, |p| p.fraction),
            seconds: shown.began.elapsed().as_secs_f64(),
            seconds_left: shown.clock.seconds_left(),
            trouble: shown.trouble.clone(),
            picture: snapshot.map(PictureState::of),
            errors: errors.iter().filter_map(ErrorState::of).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vkpt::film::Film;

    fn board() -> Board {
        Board::new("room".to_owned(), Arc::default())
    }

    fn snapshot(number: u64) -> Arc<Snapshot> {
        let film = Film {
            width: 1,
            height: 1,
            rgb: vec![[1.0; 3]],
        };
        Arc::new(Snapshot {
            number,
            film,
            origin: [0, 0],
            samples: 1,
            errors: Vec::new(),
        })
    }

    fn asked(has: u64) -> Asked {
        Asked {
            tab: Some(1),
            has,
            knows_end: false,
        }
    }

    #[test]
    fn a_snapshot_is_wanted_by_a_tab_that_has_the_newest() {
        let board = board();
        assert!(!board.is_wanted(), "no tab is open");
        board.answer(asked(0));
        assert!(board.is_wanted());
        board.show(snapshot(1));
        assert!(!board.is_wanted());
        board.answer(asked(0));
        assert!(!board.is_wanted(), "the newest is on its way to it");
        board.answer(asked(1));
        assert!(board.is_wanted());
    }

    #[test]
    fn the_end_waits_for_a_tab_that_lacks_the_last_picture() {
        let board = board();
        let waited = |board: &Board| {
            let start = Instant::now();
            board.wait_for_tabs();
            start.elapsed()
        };
        assert!(waited(&board) < PATIENCE / 2);
        board.answer(asked(0));
        board.show(snapshot(1));
        board.enter(Phase::Ended);
        assert!(waited(&board) >= PATIENCE);
        board.answer(asked(1));
        assert!(waited(&board) >= PATIENCE, "it may not know");
        std::thread::scope(|scope| {
            let knows_end = true;
            let last = Asked {
                knows_end,
                ..asked(1)
            };
            let board = &board;
            scope.spawn(move || board.answer(last));
            assert!(waited(board) < PATIENCE / 2);
        });
    }

    #[test]
    fn lost_devices_are_reported() {
        let board = board();
        assert_eq!(board.answer(asked(0)).trouble, None);
        board.trouble("the device failed".to_owned());
        let trouble = board.answer(asked(0)).trouble;
        assert_eq!(trouble.as_deref(), Some("the device failed"));
    }

    #[test]
    fn whoever_asks_to_stop_sets_the_flag() {
        let stop = Arc::default();
        let board = Board::new("room".to_owned(), Arc::clone(&stop));
        assert!(!board.answer(asked(0)).stopping);
        board.stop();
        assert!(stop.load(Ordering::Relaxed) && board.answer(asked(0)).stopping);
    }
}
