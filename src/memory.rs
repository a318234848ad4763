//! The memory that this process took and may still take, where Linux tells.

use std::fs;
use std::path::Path;

/// What may still be taken, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Free {
    /// Without swapping.
    pub quick: u64,
    /// By any means.
    pub all: u64,
}

/// The least that the machine, the control groups of this process and its own limit leave.
pub fn free() -> Option<Free> {
    let [quick, swap] = ["MemAvailable:", "SwapFree:"].map(|name| kibibytes("/proc/meminfo", name));
    let machine = Free {
        quick: quick?,
        all: quick? + swap.unwrap_or(0),
    };
    let limits = [group_limit(), space_left()].into_iter().flatten();
    Some(limits.fold(machine, |free, limit| Free {
        quick: free.quick.min(limit),
        all: free.all.min(limit),
    }))
}

/// What this process holds.
pub fn held() -> Option<u64> {
    kibibytes("/proc/self/status", "VmRSS:")
}

/// The most memory that this process has held at once.
pub fn peak() -> Option<u64> {
    kibibytes("/proc/self/status", "VmHWM:")
}

/// The least `memory.max` of the control group (version 2) of this process and those above it, as containers and batch
/// systems set it.
fn group_limit() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    let own = groups.lines().find_map(|line| line.strip_prefix("0::/"))?;
    let limit = |group: &Path| {
        let file = Path::new("/sys/fs/cgroup").join(group).join("memory.max");
        fs::read_to_string(file).ok()?.trim().parse().ok()
    };
    Path::new(own).ancestors().filter_map(limit).min()
}

/// What `ulimit -v` leaves.
fn space_left() -> Option<u64> {
    let limits = fs::read_to_string("/proc/self/limits").ok()?;
    let mut lines = limits.lines();
    let line = lines.find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(limit.saturating_sub(kibibytes("/proc/self/status", "VmSize:")?))
}

/// A line `NAME 123 kB` of a file, in bytes.
fn kibibytes(file: &str, name: &str) -> Option<u64> {
    let text = fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib * 1024)
}
