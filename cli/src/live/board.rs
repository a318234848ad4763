//! The board between the rendering, which writes on it and goes on, and the server, whose tabs read it.

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

/// No end waits longer for tabs to get the last picture.
const PATIENCE: Duration = Duration::from_millis(1500);

/// What there is to see. Nobody holds its lock for longer than it takes to copy a few words.
#[derive(Debug)]
pub struct Board {
    /// What is rendered.
    pub title: String,
    /// Tells this rendering from one that comes after it at the same port.
    run: u32,
    /// Set once somebody asks the rendering to end early.
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
    /// A tab has the newest snapshot.
    wanted: bool,
    tabs: Tabs,
}

impl Board {
    /// An empty board. Time begins now.
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

    /// How far the rendering is.
    pub fn report(&self, progress: Progress) {
        self.shown().clock.report(progress);
    }

    /// What became of a device.
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

    /// The rendering goes on to this.
    pub fn enter(&self, phase: Phase) {
        self.shown().phase = phase;
    }

    /// Waits until every tab that is there has all, but not for long.
    pub fn wait_for_tabs(&self) {
        // However this ends, the program does next.
        let _ = self
            .asked
            .wait_timeout_while(self.shown(), PATIENCE, |shown| shown.tabs.wait());
    }

    /// Asks the rendering to end early.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// The newest snapshot.
    pub fn snapshot(&self) -> Option<Arc<Snapshot>> {
        self.shown().snapshot.clone()
    }

    /// What a tab is told that asks.
    pub fn tell(&self, asked: Asked) -> State {
        let mut shown = self.shown();
        let newest = shown.snapshot.as_ref().map_or(0, |s| s.number);
        let is_up_to_date = asked.has == newest;
        shown.wanted |= is_up_to_date;
        if let Some(tab) = asked.tab {
            // What it is told now may be lost with the program's end: it must say that it was told.
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
        assert!(!board.is_wanted(), "nobody looks on");
        board.tell(asked(0));
        assert!(board.is_wanted());
        board.show(snapshot(1));
        assert!(!board.is_wanted());
        board.tell(asked(0));
        assert!(!board.is_wanted(), "the newest is on its way to it");
        board.tell(asked(1));
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
        board.tell(asked(0));
        board.show(snapshot(1));
        board.enter(Phase::Ended);
        assert!(waited(&board) >= PATIENCE);
        board.tell(asked(1));
        assert!(waited(&board) >= PATIENCE, "it may not know");
        std::thread::scope(|scope| {
            let knows_end = true;
            let last = Asked {
                knows_end,
                ..asked(1)
            };
            let board = &board;
            scope.spawn(move || board.tell(last));
            assert!(waited(board) < PATIENCE / 2);
        });
    }

    #[test]
    fn what_became_of_a_device_is_told() {
        let board = board();
        assert_eq!(board.tell(asked(0)).trouble, None);
        board.trouble("the device failed".to_owned());
        let told = board.tell(asked(0)).trouble;
        assert_eq!(told.as_deref(), Some("the device failed"));
    }

    #[test]
    fn whoever_asks_to_stop_sets_the_flag() {
        let stop = Arc::default();
        let board = Board::new("room".to_owned(), Arc::clone(&stop));
        assert!(!board.tell(asked(0)).stopping);
        board.stop();
        assert!(stop.load(Ordering::Relaxed) && board.tell(asked(0)).stopping);
    }
}
