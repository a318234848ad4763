//! The source of the bounds: roundings × condition × 2⁻²⁴.

/// Half an ulp of 1 in f32: the most that one rounding changes a number, relative to it.
pub const ROUNDING: f64 = 1.0 / 16_777_216.0;

/// Roundings between one vertex of a path and the next. The longest chain is that of a direction: quadratic, root and
/// point of the hit (some 30), frame (20), micro-normal and refraction in it (40), back to the world (15), weight (15).
/// All of one sign, which is the worst case.
pub const ROUNDINGS_PER_VERTEX: f64 = 128.0;

/// Decisions at a vertex: the shape that is hit, whether the light arrives, the lobe with reflection or refraction, roulette.
pub const DECISIONS_PER_VERTEX: f64 = 4.0;

/// Relative error that f32 causes in the throughput of a path with that many vertices.
pub fn carried(vertices: f64, condition: f64) -> f64 {
    vertices * ROUNDINGS_PER_VERTEX * condition * ROUNDING
}

/// Probability that f32 decides differently somewhere on this path. A decision compares a number x with a uniform one, or
/// a point with an edge around which it is uniform: an error δ of x changes a fraction δ of the decisions.
pub fn diverged(vertices: f64, condition: f64) -> f64 {
    (DECISIONS_PER_VERTEX * carried(vertices, condition)).min(1.0)
}
