//! The kernels' hierarchy as a data structure: decoded here anew from its words, compared with exact boxes.

use glam::DVec3;
use vkpt::flat::bvh::reference::decode;
use vkpt::flat::bvh::{self, Bvh};
use vkpt::prepared::{Prepared, ShapeKind};
use vkpt::shape::Extent;

use super::scenes::{self, Builder};

pub const ALL_KINDS: [ShapeKind; 4] = ShapeKind::EVERY;

/// The result of a walk over a tree.
#[derive(Default)]
struct Walk {
    /// How often each reference was met.
    met: Vec<u32>,
    nodes: usize,
    /// Most entries on the stack of a traversal that enters every node, children in order of slots.
    deepest: u32,
    outside: usize,
}

/// Visits `node` with `pushed` entries on the stack; every primitive must lie within all of `within`.
fn walk(
    bvh: &Bvh,
    prepared: &Prepared,
    node: usize,
    pushed: u32,
    within: &mut Vec<[DVec3; 2]>,
    seen: &mut Walk,
) {
    let words = &bvh.nodes[node];
    let byte = |word: usize, i: usize| words[word + i / 4].to_le_bytes()[i % 4];
    let inner = words[3] >> 24;
    seen.nodes += 1;
    let mut rank = 0;
    for slot in 0..8 {
        let plane = |first: usize, axis: usize| {
            let step = f64::from(f32::from_bits(
                u32::from(words[3].to_le_bytes()[axis]) << 23,
            ));
            f64::from(f32::from_bits(words[axis])) + f64::from(byte(first + 4 * axis, slot)) * step
        };
        within.push(
            [8, 10].map(|first| DVec3::new(plane(first, 0), plane(first, 1), plane(first, 2))),
        );
        let meta = u32::from(byte(6, slot));
        if inner >> slot & 1 == 1 {
            assert_eq!(meta, 0b001_11000 | slot as u32);
            rank += 1;
            let stack = pushed + u32::from(rank < inner.count_ones());
            seen.deepest = seen.deepest.max(stack);
            walk(
                bvh,
                prepared,
                (words[4] + rank - 1) as usize,
                stack,
                within,
                seen,
            );
        } else {
            for i in 0..(meta >> 5).count_ones() {
                let reference = (words[5] + (meta & 31) + i) as usize;
                seen.met[reference] += 1;
                let b = bounds(prepared, bvh.references[reference]);
                let [lo, hi] = [b.lo, b.hi].map(|v| DVec3::from_array(v.map(f64::from)));
                seen.outside += usize::from(
                    !within
                        .iter()
                        .all(|w| w[0].cmple(lo).all() && hi.cmple(w[1]).all()),
                );
            }
        }
        within.pop();
    }
}

pub fn bounds(prepared: &Prepared, reference: u32) -> Extent {
    let (kind, i) = decode(reference);
    Extent::around(prepared.primitives.get(kind, i).extent_in_f32())
}

fn walked(bvh: &Bvh, prepared: &Prepared) -> Walk {
    let mut seen = Walk {
        met: vec![0; bvh.references.len()],
        ..Walk::default()
    };
    walk(bvh, prepared, 0, 0, &mut Vec::new(), &mut seen);
    seen
}

/// Every primitive is in exactly one leaf and inside every box above it; the stack's bound is kept.
fn check(name: &str, prepared: &Prepared) -> Bvh {
    let bvh = bvh::build(prepared, &ALL_KINDS);
    let seen = walked(&bvh, prepared);
    assert!(
        seen.met.iter().all(|&n| n == 1),
        "{name}: a reference is not in exactly one leaf"
    );
    let mut references = bvh.references.clone();
    references.sort_unstable();
    references.dedup();
    let p = &prepared.primitives;
    let primitives = p.spheres.len() + p.boxes.len() + p.cylinders.len() + p.triangles.len();
    assert_eq!(references.len(), primitives, "{name}");
    assert_eq!(seen.nodes, bvh.nodes.len(), "{name}");
    assert_eq!(
        seen.outside, 0,
        "{name}: a box does not enclose what lies below it"
    );
    assert!(seen.deepest <= bvh.stack, "{name}: depth of the stack");
    bvh
}

#[test]
fn trees_enclose_their_primitives() {
    for (name, prepared) in scenes::all() {
        check(name, &prepared);
    }
}

#[test]
fn an_empty_tree_has_one_node_without_children() {
    let bvh = bvh::build(&scenes::cube(), &[ShapeKind::Sphere]);
    assert_eq!(
        (bvh.nodes.len(), bvh.references.len(), bvh.stack),
        (1, 0, 1)
    );
    assert_eq!(bvh.nodes[0], [0; bvh::NODE_WORDS]);
}

/// Of so many triangles that each step of the builder takes all threads that it gets.
#[test]
fn trees_are_the_same_on_any_number_of_cores() {
    for prepared in [
        scenes::mixed(),
        Builder::new().mesh(scenes::grid(512)).build(),
    ] {
        let on_cores = |cores| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(cores).build();
            pool.unwrap().install(|| bvh::build(&prepared, &ALL_KINDS))
        };
        let tree = on_cores(1);
        assert!(tree == on_cores(2) && tree == on_cores(5));
    }
}

/// Scenes in which all merges cost the same, and scenes of extreme size: quick to build, shallow.
#[test]
fn degenerate_scenes_build_shallow_trees() {
    let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let row = |step: DVec3| move |k: u32| triangle.map(|v| v + step * f64::from(k));
    let point = |k: u32| [DVec3::X * f64::from(k); 3];
    let scenes = [
        (
            "coincident",
            Builder::new().mesh(vec![triangle; 50_000]).build(),
        ),
        (
            "coincident points",
            Builder::new().mesh(vec![[DVec3::ONE; 3]; 50_000]).build(),
        ),
        (
            "points in a row",
            Builder::new().mesh((0..50_000).map(point)).build(),
        ),
        (
            "a row",
            Builder::new().mesh((0..50_000).map(row(DVec3::X))).build(),
        ),
        ("a grid", Builder::new().mesh(scenes::grid(256)).build()),
        (
            "huge",
            Builder::new()
                .mesh(scenes::grid(16).into_iter().map(|t| t.map(|v| v * 1e30)))
                .build(),
        ),
        (
            "tiny",
            Builder::new()
                .mesh(scenes::grid(16).into_iter().map(|t| t.map(|v| v * 1e-30)))
                .build(),
        ),
    ];
    for (name, prepared) in &scenes {
        let start = std::time::Instant::now();
        let bvh = check(name, prepared);
        println!(
            "{name}: stack {}, nodes {}, {:?}",
            bvh.stack,
            bvh.nodes.len(),
            start.elapsed()
        );
        assert!(bvh.stack <= 16, "{name}: a stack of {}", bvh.stack);
    }
}

/// The comparator sees a box that is one plane too small.
#[test]
fn a_shrunken_box_is_noticed() {
    let prepared = scenes::blob();
    let mut bvh = bvh::build(&prepared, &ALL_KINDS);
    let slot = (0..8)
        .find(|&i| bvh.nodes[0][10 + i / 4].to_le_bytes()[i % 4] > 0)
        .unwrap();
    bvh.nodes[0][10 + slot / 4] -= 1 << (8 * (slot % 4));
    assert!(walked(&bvh, &prepared).outside > 0);
}
