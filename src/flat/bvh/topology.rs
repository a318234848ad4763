//! Clusters primitives: the tree's topology comes from the crate `obvhs`.
//!
//! PLOC (Meister & Bittner, Parallel Locally-Ordered Clustering for BVH Construction, TVCG 2018), improved by
//! reinsertion (Meister & Bittner, Parallel Reinsertion for BVH Optimization, EG 2018), collapsed to eight children per
//! node (Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, HPG 2017,
//! section 3). It uses all cores; the tree is the same for any number of them.

use glam::Vec3A;
use obvhs::aabb::Aabb;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::bvh2_to_cwbvh::bvh2_to_cwbvh;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use rayon::prelude::*;

use crate::shape::Extent;

/// The paper's limit for leaves, given by the unary count of three bits.
const PRIMITIVES_PER_LEAF: u32 = 3;
/// Passes of PLOC that inspect only direct neighbours, and the share of nodes reinserted: the middle one of the presets
/// of `obvhs`. The costliest takes four times as long to build and is 2 to 8 per cent faster to traverse.
const NEIGHBOUR_PASSES: usize = 3;
const REINSERTED: f32 = 0.05;

/// The tree over `bounds`, at least one box. Only its topology is usable: its boxes are those of [`scattered`], not
/// `bounds`.
pub fn topology(bounds: &[Extent]) -> CwBvh {
    let boxes = scattered(bounds);
    let indices = (0..boxes.len() as u32).collect();
    let mut binary = PlocBuilder::with_capacity(boxes.len()).build(
        PlocSearchDistance::Medium,
        &boxes,
        indices,
        SortPrecision::U64,
        NEIGHBOUR_PASSES,
    );
    ReinsertionOptimizer::default().run(&mut binary, REINSERTED, None);
    bvh2_to_cwbvh(&binary, PRIMITIVES_PER_LEAF, true, false)
}

/// The boxes moved and scaled into [−1, 1]³, so that no area under- or overflows, with every side pushed out by a
/// random share of 2⁻¹⁰ of the box's length.
///
/// PLOC merges two clusters that are each other's cheapest partner, and picks the last among equal partners. Where all
/// are equal (a regular grid, coincident triangles) only one pair would merge per pass: quadratic time and, for
/// coincident ones, a tree as deep as it has leaves. (50,000 coincident triangles: .07 s, a stack of 12; unscattered a
/// minute, then an overflow of the builder's own stack.)
fn scattered(bounds: &[Extent]) -> Vec<Aabb> {
    let all = (bounds.par_iter().copied()).reduce(|| Extent::EMPTY, Extent::union);
    let lo = all.lo.map(f64::from);
    let extent = (0..3)
        .map(|k| f64::from(all.hi[k]) - lo[k])
        .fold(f64::MIN_POSITIVE, f64::max);
    let unit = |x: f32, k: usize| (f64::from(x) - lo[k]) / extent * 2.0 - 1.0;
    let scatter = |(i, b): (usize, &Extent)| {
        let min: [f64; 3] = std::array::from_fn(|k| unit(b.lo[k], k));
        let max: [f64; 3] = std::array::from_fn(|k| unit(b.hi[k], k));
        let length = (0..3).map(|k| max[k] - min[k]).fold(0.0, f64::max);
        let step = (length * 2f64.powi(-10)).max(2f64.powi(-20));
        let push = |side: usize| step * random(6 * i as u64 + side as u64);
        Aabb::new(
            Vec3A::from_array(std::array::from_fn(|k| (min[k] - push(k)) as f32)),
            Vec3A::from_array(std::array::from_fn(|k| (max[k] + push(3 + k)) as f32)),
        )
    };
    bounds.par_iter().enumerate().map(scatter).collect()
}

/// A number in [0, 1) from the counter `k`: SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom
/// Number Generators, OOPSLA 2014).
fn random(k: u64) -> f64 {
    let mut z = k.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 * 2f64.powi(-53)
}
