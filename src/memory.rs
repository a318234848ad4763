//! The memory that this process uses and can still allocate, as far as Linux reports it.

use std::fs;
use std::path::Path;

/// Available memory in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Free {
    /// Without swapping.
    pub quick: u64,
    /// Including swap.
    pub all: u64,
}

/// The minimum of the limits of the machine, of this process's control groups and of the process itself.
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

/// Memory in use by this process.
pub fn in_use() -> Option<u64> {
    kibibytes("/proc/self/status", "VmRSS:")
}

/// Peak memory use of this process.
pub fn peak() -> Option<u64> {
    kibibytes("/proc/self/status", "VmHWM:")
}

/// The smallest `memory.max` of this process's control group (version 2) and its ancestors, as set by containers and
/// batch systems.
fn group_limit() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    let own = groups.lines().find_map(|line| line.strip_prefix("0::/"))?;
    let limit = |group: &Path| {
        let file = Path::new("/sys/fs/cgroup").join(group).join("memory.max");
        fs::read_to_string(file).ok()?.trim().parse().ok()
    };
    Path::new(own).ancestors().filter_map(limit).min()
}

/// The remainder of the limit of `ulimit -v`.
fn space_left() -> Option<u64> {
    let limits = fs::read_to_string("/proc/self/limits").ok()?;
    let mut lines = limits.lines();
    let line = lines.find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(limit.saturating_sub(kibibytes("/proc/self/status", "VmSize:")?))
}

/// The value of a line `NAME 123 kB` of a file, in bytes.
fn kibibytes(file: &str, name: &str) -> Option<u64> {
    let text = fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib * 1024)
}
