//! The expected result of each invocation of the self-tests, by its index; twins of the files of `shaders/doctor/`.

use vkpt::layout::constants::workgroup::WORKGROUP;
use vkpt::reference::sampler::pcg4d::pcg4d;

/// `invocations.comp`, once, on a word that contained the index.
pub fn invocations(i: u32) -> u32 {
    i.wrapping_mul(31).wrapping_add(i)
}

/// `loop_one_exit.comp` and `loop_restart.comp`.
pub fn lives(i: u32) -> u32 {
    let born = |life| pcg4d([i, life, 0, 0])[0];
    let (mut life, mut age, mut sum, mut state) = (0, 0, 0u32, born(0));
    while life < 16 {
        state = congruential(state);
        age += 1;
        let dies = state >> 28 == 0 || age == 40;
        sum = sum
            .wrapping_mul(31)
            .wrapping_add(if dies { age } else { state >> 30 });
        if dies {
            life += 1;
            age = 0;
            state = born(life);
        }
    }
    sum
}

fn congruential(state: u32) -> u32 {
    state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453)
}

/// `loop_break.comp`.
pub fn collatz(i: u32) -> u32 {
    (1..=8).fold(0u32, |sum, start| {
        let (mut n, mut steps) = (i + start, 0);
        while n > 1 && n & 63 != 37 {
            n = if n & 1 == 0 {
                n >> 1
            } else {
                n.wrapping_mul(3).wrapping_add(1)
            };
            steps += 1;
        }
        sum.wrapping_mul(31).wrapping_add(steps)
    })
}

/// `guard.comp`; the words given are the indices.
pub fn guard(i: u32) -> u32 {
    let r = pcg4d([i, 1, 0, 0]);
    let (found, mut calls) = if r[0] & 1 == 0 { (11u32, 1) } else { (7, 0) };
    let chosen = if r[1] & 2 == 0 {
        calls += 256;
        r[2]
    } else {
        calls += 65_536;
        r[3]
    };
    found.wrapping_mul(31).wrapping_add(chosen) ^ calls
}

/// `stack.comp`.
pub fn stack(i: u32) -> u32 {
    let (mut stack, mut sum, mut visits) = (vec![i], 0u32, 0);
    while visits < 200 {
        let Some(node) = stack.pop() else { break };
        visits += 1;
        sum = sum.wrapping_mul(31).wrapping_add(node);
        let children = pcg4d([node, visits, 0, 0])[0] >> 30;
        let room = 24 - stack.len();
        let pushed = (1..=children).map(|child| node.wrapping_mul(4).wrapping_add(child));
        stack.extend(pushed.take(room));
    }
    sum
}

/// A row of the uniform table.
pub fn row(k: u32) -> [u32; 4] {
    pcg4d([k, 6, 0, 0])
}

/// `table.comp`.
pub fn table(i: u32) -> u32 {
    let at = pcg4d([i, 2, 0, 0]).map(|word| word >> 22);
    let part = |k: usize| row(at[k])[k].wrapping_mul(2 * k as u32 + 1);
    (0..4).map(part).fold(0, u32::wrapping_add)
}

/// `structs.comp`.
pub fn structs(i: u32) -> u32 {
    let before = ([pcg4d([i, 3, 0, 0]), pcg4d([i, 3, 1, 0])], 0u32);
    let (mut media, mut length) = before;
    for turn in 0..1 + (i & 3) {
        media.swap(0, 1);
        media[1][3] = media[1][3].wrapping_add(turn);
        length += 1;
    }
    let weigh = |m: [u32; 4]| {
        (0..4).fold(0u32, |sum, k| {
            sum.wrapping_add(m[k].wrapping_mul(2 * k as u32 + 1))
        })
    };
    let digest = |(media, length): ([[u32; 4]; 2], u32)| {
        let inside = weigh(media[0]).wrapping_mul(31);
        inside
            .wrapping_add(weigh(media[1]))
            .wrapping_mul(31)
            .wrapping_add(length)
    };
    let after = digest((media, length));
    let sum = after.wrapping_mul(31).wrapping_add(digest(before));
    sum.wrapping_mul(31)
        .wrapping_add(if i & 1 == 0 { after } else { digest(before) })
}

/// `hand_over.comp`, three times, starting from the indices.
pub fn hand_over(i: u32) -> u32 {
    fn after(dispatches: u32, i: u32) -> u32 {
        if dispatches == 0 {
            return i;
        }
        let from = pcg4d([i, 4, 0, 0])[0] & 0xffff;
        after(dispatches - 1, from).wrapping_mul(31).wrapping_add(i)
    }
    after(3, i)
}

/// `barrier.comp`.
pub fn barrier(i: u32) -> u32 {
    let word = |i: u32| {
        let steps = pcg4d([i, 5, 0, 0])[0] >> 27;
        (0..steps).fold(i, |word, _| congruential(word))
    };
    let lane = i % WORKGROUP;
    let group = i - lane;
    let sum = (group..group + WORKGROUP)
        .map(word)
        .fold(0, u32::wrapping_add);
    sum.wrapping_add(lane)
}
