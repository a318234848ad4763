//! The samples of every pixel that each part renders.

use std::ops::Range;

use vkpt::part::BLOCK;

/// Samples of every pixel, by their indices.
pub type Share = Range<u32>;

/// All of `samples` in `tasks` shares, or in as many as there are samples. They are about equal, and whole blocks if there is one for
/// each: a part that starts within a block stores each sample of that block separately.
pub fn shares(samples: Share, tasks: u32) -> Vec<Share> {
    let count = samples.len() as u64;
    let tasks = u64::from(tasks).min(count);
    let Some(size) = count.checked_div(tasks) else {
        return Vec::new();
    };
    let block = if size < u64::from(BLOCK) {
        1
    } else {
        u64::from(BLOCK)
    };
    let blocks = count.div_ceil(block);
    let begin = |task: u64| samples.start + (blocks * task / tasks * block).min(count) as u32;
    (0..tasks)
        .map(|task| begin(task)..begin(task + 1))
        .collect()
}

/// Rounds of up to `tasks` shares each: the first has a block for each task, each later one as many samples as all before it together,
/// until there are `spp`.
pub fn rounds(spp: u32, tasks: u32) -> Vec<Vec<Share>> {
    let ends = std::iter::successors(Some(tasks.saturating_mul(BLOCK)), |end| {
        (*end < spp).then(|| end.saturating_mul(2))
    });
    let mut begin = 0;
    ends.map(|end| shares(std::mem::replace(&mut begin, end)..end.min(spp), tasks))
        .collect()
}
