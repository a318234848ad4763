//! The choice of one of many lights: down a tree, at each node by the importance of its halves; twin of
//! `shaders/light/tree/descent.glsl`.

use super::LightNode;
use super::importance::node_importance;
use super::tickets::{Tickets, all_tickets, first_share, refilled};
use crate::reference::math::{Real, Vec3};

/// A light and the probability of its choice.
#[derive(Clone, Copy, Debug)]
pub struct TreeChoice<F> {
    pub light: u32,
    /// Probability of the choice; 0: no light can contribute here.
    pub pmf: F,
}

/// The share of the first child of node `i`, the one that follows it, among `count` tickets; 2³² − 1 if neither can contribute.
pub fn first_child_share<F: Real>(
    nodes: &[LightNode<F>],
    i: u32,
    count: u32,
    p: Vec3<F>,
    n: Vec3<F>,
) -> u32 {
    let a = node_importance(&nodes[i as usize + 1], p, n);
    let b = node_importance(&nodes[nodes[i as usize].child as usize], p, n);
    if a + b > F::zero() {
        first_share(count, a, b)
    } else {
        u32::MAX
    }
}

/// A light for the point `p` with normal `n`, or n = 0.
pub fn tree_choice<F: Real>(
    nodes: &[LightNode<F>],
    p: Vec3<F>,
    n: Vec3<F>,
    all: Tickets,
) -> TreeChoice<F> {
    let mut t = all;
    let mut i = 0;
    let mut pmf = F::one();
    while nodes[i as usize].leaf == 0 && pmf > F::zero() {
        let share = first_child_share(nodes, i, t.count, p, n);
        if share == u32::MAX {
            pmf = F::zero();
            break;
        }
        let first = t.drawn < share;
        let count = if first { share } else { t.count - share };
        pmf *= F::from_u32(count) / F::from_u32(t.count);
        i = if first {
            i + 1
        } else {
            nodes[i as usize].child
        };
        t.drawn -= if first { 0 } else { share };
        t.count = count;
        t = refilled(t);
    }
    TreeChoice {
        light: nodes[i as usize].child,
        pmf,
    }
}

/// The probability of that choice for the light that `trail` leads to.
pub fn tree_pmf<F: Real>(nodes: &[LightNode<F>], mut trail: u32, p: Vec3<F>, n: Vec3<F>) -> F {
    let mut t = all_tickets([0; 4]);
    let mut i = 0;
    let mut pmf = F::one();
    while nodes[i as usize].leaf == 0 && pmf > F::zero() {
        let share = first_child_share(nodes, i, t.count, p, n);
        if share == u32::MAX {
            return F::zero();
        }
        let first = trail & 1 == 0;
        let count = if first { share } else { t.count - share };
        pmf *= F::from_u32(count) / F::from_u32(t.count);
        i = if first {
            i + 1
        } else {
            nodes[i as usize].child
        };
        trail >>= 1;
        t.count = count;
        t = refilled(t);
    }
    pmf
}
