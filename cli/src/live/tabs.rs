//! The open tabs, by their random numbers.

use std::collections::HashMap;
use std::time::{Duration, Instant};

/// A tab that has not asked for this long is closed: browsers let background tabs ask once a second.
const GONE: Duration = Duration::from_millis(2500);

/// More than anybody opens; limits programs that make up numbers endlessly.
const MOST: usize = 1000;

/// The open tabs.
#[derive(Debug, Default)]
pub struct Tabs {
    /// When each asked last, and whether it has everything.
    all: HashMap<u64, (Instant, bool)>,
}

impl Tabs {
    /// A tab asks now.
    pub fn asks(&mut self, tab: u64, has_all: bool) {
        self.all.retain(|_, (last, _)| last.elapsed() < GONE);
        if self.all.len() < MOST {
            self.all.insert(tab, (Instant::now(), has_all));
        }
    }

    /// Whether any open tab does not have everything.
    pub fn wait(&self) -> bool {
        let there = |last: &Instant| last.elapsed() < GONE;
        self.all
            .values()
            .any(|(last, has_all)| there(last) && !has_all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tab_waits_until_it_has_all_or_is_gone() {
        let mut tabs = Tabs::default();
        assert!(!tabs.wait());
        tabs.asks(1, false);
        tabs.asks(2, true);
        assert!(tabs.wait());
        tabs.asks(1, true);
        assert!(!tabs.wait());
        tabs.asks(3, false);
        let before = Instant::now().checked_sub(GONE).expect("a clock that runs");
        tabs.all.insert(3, (before, false));
        assert!(!tabs.wait());
    }

    #[test]
    fn numbers_without_end_take_no_memory() {
        let mut tabs = Tabs::default();
        (0..2 * MOST as u64).for_each(|tab| tabs.asks(tab, false));
        assert_eq!(tabs.all.len(), MOST);
    }
}
