//! A running process, as Linux reports it.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// Its folder in `/proc`.
pub struct Process(pub PathBuf);

impl Process {
    /// A file of its folder; nothing once it has ended.
    pub fn says(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap_or_default()
    }

    /// Whether it has computed for a fifth of a second, which is more than a rendering takes to begin.
    pub fn has_begun(&self) -> bool {
        let stat = self.says("stat");
        let fields = stat.rsplit(')').next().unwrap_or_default();
        let mut fields = fields.split_whitespace();
        // proc_pid_stat(5): utime, in hundredths of a second.
        let ticks = fields.nth(11).and_then(|ticks| ticks.parse().ok());
        ticks.is_some_and(|ticks: u32| ticks >= 20)
    }

    /// Whether TERM waits until the process continues.
    pub fn has_term_pending(&self) -> bool {
        let status = self.says("status");
        let mut lines = status.lines();
        let mask = lines.find_map(|line| line.strip_prefix("ShdPnd:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        mask.is_some_and(|mask| mask & 1 << 14 != 0)
    }

    pub fn send(&self, signal: &str) {
        let id = self.0.file_name().expect("a number");
        let kill = format!("kill -{signal} {}", id.to_string_lossy());
        let sent = Command::new("sh").args(["-c", &kill]).status();
        assert!(sent.expect("sh runs").success(), "{kill}");
    }
}
