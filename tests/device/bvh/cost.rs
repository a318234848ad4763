//! The computed cost of a hierarchy, against lines that are drawn at random.

use glam::DVec3;
use vkpt::flat::bvh::{self, Bvh};
use vkpt::prepared::Prepared;
use vkpt::shape::Extent;

use super::random::Random;
use super::scenes::{self, Builder};
use super::tree::{ALL_KINDS, bounds};
use crate::common::stats::p_of_mean;

/// A node that a line meets: an inner node, or a leaf of that many primitives.
struct Body {
    bounds: Extent,
    /// `None`: a node.
    leaf: Option<u32>,
}

/// All nodes and leaves below `node`, its own box last.
fn bodies(bvh: &Bvh, prepared: &Prepared, node: usize, all: &mut Vec<Body>) -> Extent {
    let words = &bvh.nodes[node];
    let mut whole = Extent::EMPTY;
    let mut inner = 0;
    for slot in 0..8 {
        let meta = u32::from(words[6 + slot / 4].to_le_bytes()[slot % 4]);
        if (words[3] >> 24) >> slot & 1 == 1 {
            whole = whole.union(bodies(bvh, prepared, (words[4] + inner) as usize, all));
            inner += 1;
        } else if meta != 0 {
            let (first, count) = (words[5] + (meta & 31), (meta >> 5).count_ones());
            let leaf = (first..first + count)
                .map(|i| bounds(prepared, bvh.references[i as usize]))
                .fold(Extent::EMPTY, Extent::union);
            whole = whole.union(leaf);
            all.push(Body {
                bounds: leaf,
                leaf: Some(count),
            });
        }
    }
    all.push(Body {
        bounds: whole,
        leaf: None,
    });
    whole
}

/// Whether the line through `o` along `d` meets the box, by the slabs' common interval.
fn meets(b: Extent, o: DVec3, d: DVec3) -> bool {
    let [lo, hi] = [b.lo, b.hi].map(|v| (DVec3::from_array(v.map(f64::from)) - o) / d);
    lo.min(hi).max_element() <= lo.max(hi).min_element()
}

/// Nodes and primitives met by each of `n` lines that meet the scene's box. Two independent points of a sphere span
/// a line of the uniform measure (Santaló, Integral Geometry and Geometric Probability, 1976, chapter 12).
fn drawn(all: &[Body], n: usize) -> [Vec<f64>; 2] {
    let root = all.last().expect("a root").bounds;
    let [lo, hi] = [root.lo, root.hi].map(|v| DVec3::from_array(v.map(f64::from)));
    let (centre, radius) = ((lo + hi) / 2.0, (hi - lo).length() / 2.0);
    let mut random = Random::new(11);
    let mut counts = [Vec::new(), Vec::new()];
    while counts[0].len() < n {
        let [a, b] = [(); 2].map(|()| centre + random.direction() * radius);
        if !meets(root, a, b - a) {
            continue;
        }
        let met = || all.iter().filter(|body| meets(body.bounds, a, b - a));
        counts[0].push(met().filter(|body| body.leaf.is_none()).count() as f64);
        counts[1].push(met().filter_map(|body| body.leaf).map(f64::from).sum());
    }
    counts
}

#[test]
fn random_lines_meet_as_many_nodes_and_primitives_as_the_cost_says() {
    for (name, prepared) in [
        ("mixed", scenes::mixed()),
        ("spheres", scenes::spheres(200)),
    ] {
        let bvh = bvh::build(&prepared, &ALL_KINDS);
        let mut all = Vec::new();
        bodies(&bvh, &prepared, 0, &mut all);
        let [nodes, primitives] = drawn(&all, 20_000);
        let p = |samples: &[f64], cost| p_of_mean(samples, cost, 1e-9);
        // Four tests, α = 1e-3 in all (Šidák).
        let least = 2.5e-4;
        assert!(p(&nodes, bvh.cost.nodes) > least, "{name}: {:?}", bvh.cost);
        assert!(
            p(&primitives, bvh.cost.primitives) > least,
            "{name}: {:?}",
            bvh.cost
        );
        // The test can fail.
        assert!(p(&nodes, 1.05 * bvh.cost.nodes) < least, "{name}");
        assert!(p(&primitives, 1.05 * bvh.cost.primitives) < least, "{name}");
    }
}

/// Two unit cubes at both ends of a box of 4 × 1 × 1: a line through it meets each with probability 6/18.
#[test]
fn the_cost_of_two_cubes_is_known() {
    let x = |x: f64| DVec3::new(x, 0.0, 0.0);
    let scene = Builder::new()
        .cuboid(x(0.0), DVec3::ONE)
        .cuboid(x(3.0), x(3.0) + DVec3::ONE);
    let cost = bvh::build(&scene.build(), &ALL_KINDS).cost;
    assert_eq!(cost.nodes, 1.0);
    assert!((cost.primitives - 2.0 / 3.0).abs() < 1e-12, "{cost:?}");
}
