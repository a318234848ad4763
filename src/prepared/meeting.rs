//! Finds all intersecting pairs in a set of boxes: each leaf of a tree over the set is searched for in that tree, on
//! all cores.

use rayon::prelude::*;

use crate::shape::Extent;

/// Maximum number of boxes in a leaf.
const LEAF: usize = 8;

/// Calls `of_pair(i, j, found)` once for any two boxes i < j with a common point. Returns everything appended to
/// `found`, in an order that depends only on `boxes`.
pub fn meeting_pairs<T: Send>(
    boxes: &[Extent],
    of_pair: impl Fn(usize, usize, &mut Vec<T>) + Sync,
) -> Vec<T> {
    let tree = Tree::new(boxes);
    let with_later_leaves = |k| {
        let mut found = Vec::new();
        let mut test = |a: &Item, b: &Item| {
            if a.extent.meets(b.extent) {
                let (i, j) = (a.number.min(b.number), a.number.max(b.number));
                of_pair(i as usize, j as usize, &mut found);
            }
        };
        let leaf = tree.leaf(k);
        for (i, a) in leaf.iter().enumerate() {
            leaf[i + 1..].iter().for_each(|b| test(a, b));
        }
        tree.each_later_leaf(tree.top(), k, &mut |other, extent| {
            for a in leaf.iter().filter(|a| a.extent.meets(extent)) {
                other.iter().for_each(|b| test(a, b));
            }
        });
        found
    };
    let leaves = 0..tree.levels[0].len();
    leaves
        .into_par_iter()
        .flat_map_iter(with_later_leaves)
        .collect()
}

/// A box and its index.
#[derive(Clone, Copy)]
struct Item {
    extent: Extent,
    number: u32,
}

/// A complete binary tree.
struct Tree {
    /// Neighbours in space are adjacent.
    items: Vec<Item>,
    /// The boxes of nodes, leaves first. Node k has children 2k and 2k + 1 in the level before.
    levels: Vec<Vec<Extent>>,
}

/// Level, and index within it.
type Node = (usize, usize);

impl Tree {
    fn new(boxes: &[Extent]) -> Self {
        let all = (boxes.par_iter().copied()).reduce(|| Extent::EMPTY, Extent::union);
        let mut order: Vec<(u64, u32)> = (boxes.par_iter().zip(0..boxes.len() as u32))
            .map(|(extent, number)| (key(*extent, all), number))
            .collect();
        order.par_sort_unstable();
        let item = |(_, number): (u64, u32)| Item {
            extent: boxes[number as usize],
            number,
        };
        let mut tree = Self {
            items: order.into_par_iter().map(item).collect(),
            levels: Vec::new(),
        };
        let leaves = boxes.len().div_ceil(LEAF).next_power_of_two();
        tree.levels = vec![vec![Extent::EMPTY; leaves]];
        let around = |k| tree.leaf(k).iter().map(|item| item.extent).collect();
        tree.levels[0] = (0..leaves).into_par_iter().map(around).collect();
        while let Some(children) = tree.levels.last().filter(|level| level.len() > 1) {
            let parents = children.par_chunks(2).map(|two| two[0].union(two[1]));
            let parents = parents.collect();
            tree.levels.push(parents);
        }
        tree
    }

    /// The boxes of leaf k.
    fn leaf(&self, k: usize) -> &[Item] {
        let begin = |k: usize| k * self.items.len() / self.levels[0].len();
        &self.items[begin(k)..begin(k + 1)]
    }

    fn top(&self) -> Node {
        (self.levels.len() - 1, 0)
    }

    /// Calls `visit` for all leaves below `node` that come after leaf k and intersect it.
    fn each_later_leaf(&self, node: Node, k: usize, visit: &mut impl FnMut(&[Item], Extent)) {
        let (level, number) = node;
        let last = ((number + 1) << level) - 1;
        let extent = self.levels[level][number];
        if last <= k || !extent.meets(self.levels[0][k]) {
            return;
        }
        if level == 0 {
            return visit(self.leaf(number), extent);
        }
        self.each_later_leaf((level - 1, 2 * number), k, visit);
        self.each_later_leaf((level - 1, 2 * number + 1), k, visit);
    }
}

/// The sort key of a box: large boxes first, in steps of a factor of 8, because one of them enlarges all nodes above
/// it; boxes of similar size by the Morton code of their centre in `all`.
///
/// Morton, A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing, IBM 1966.
fn key(extent: Extent, all: Extent) -> u64 {
    let side = |e: Extent, axis: usize| f64::from(e.hi[axis]) - f64::from(e.lo[axis]);
    let longest = |e: Extent| side(e, 0).max(side(e, 1)).max(side(e, 2));
    // log₂ of their ratio, in steps of 3; the cast turns NaN into 0.
    let size = ((longest(all) / longest(extent)).log2() / 3.0) as u64;
    let cell = |axis: usize| {
        let centre = f64::from(extent.twice_centre()[axis]) / 2.0 - f64::from(all.lo[axis]);
        (centre / side(all, axis) * CELLS as f64) as u64
    };
    (0..3).fold(size.min(15) << 60, |key, axis| {
        key | spread(cell(axis).min(CELLS)) << axis
    })
}

/// Cells along an axis, less one.
const CELLS: u64 = (1 << 20) - 1;

/// Moves bit i of `x` (20 bits) to position 3i.
fn spread(x: u64) -> u64 {
    (0..20).fold(0, |all, i| all | (x >> i & 1) << (3 * i))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A cube around `centre`; its size may be 0.
    fn cube(centre: [i8; 3], half: f32) -> Extent {
        let side = |sign: f32| centre.map(|c| f32::from(c) + sign * half);
        Extent {
            lo: side(-1.0),
            hi: side(1.0),
        }
    }

    fn found(boxes: &[Extent]) -> Vec<(usize, usize)> {
        let mut pairs = meeting_pairs(boxes, |i, j, found| found.push((i, j)));
        pairs.sort_unstable();
        pairs
    }

    /// Straight from the definition: each box against each.
    fn expected(boxes: &[Extent]) -> Vec<(usize, usize)> {
        let apart = |a: Extent, b: Extent| (0..3).any(|k| a.hi[k] < b.lo[k] || b.hi[k] < a.lo[k]);
        let pairs = (0..boxes.len()).flat_map(|i| (i + 1..boxes.len()).map(move |j| (i, j)));
        pairs.filter(|&(i, j)| !apart(boxes[i], boxes[j])).collect()
    }

    proptest! {
        /// Integer coordinates make many boxes touch; sizes range from points to one larger than all others.
        #[test]
        fn each_pair_that_meets_is_found_once(
            sizes in prop::collection::vec((any::<[i8; 3]>(), 0u32..9), 0..300),
        ) {
            let size = |half: u32| if half == 0 { 0.0 } else { f32::from(2u16.pow(half)) / 4.0 };
            let boxes: Vec<Extent> = sizes.iter().map(|&(centre, half)| cube(centre, size(half))).collect();
            prop_assert_eq!(found(&boxes), expected(&boxes));
        }
    }

    #[test]
    fn boxes_in_one_place_all_meet() {
        let boxes = [cube([1, 2, 3], 0.0); 100];
        assert_eq!(found(&boxes).len(), 100 * 99 / 2);
    }
}
