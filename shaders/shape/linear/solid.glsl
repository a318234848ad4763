// A solid in the search for the nearest hit, once its distance is known.
// Twin of nearer_solid in src/reference/shape/linear.rs.

// uses: shape/ray

// `best`, or a hit of a solid at t >= 0 that comes before it.
Hit nearer_solid(float t, uint shape, uint prim, Target skip, Hit best) {
    bool nearer = t >= 0.0 && shape != skip.shape && closer(t, shape, prim, best);
    return Hit(nearer ? t : best.t, nearer ? shape : best.shape, nearer ? prim : best.prim,
               nearer ? vec2(0.0) : best.uv);
}
