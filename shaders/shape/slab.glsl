// The part of a ray between two parallel planes.
// Twin of src/reference/shape/slab.rs.

// uses: constants/ray, math/vec, shape/ray

// An interval of a ray; empty where near > far.
struct Slab {
    float near;
    float far;
};

// The interval with lo <= o + t d <= hi along one axis. A parallel ray is either between the planes or not; sliding
// along one of them it misses, unless it starts there to the inside.
Slab slab(float o, float d, float lo, float hi, uint start) {
    bool parallel = abs(d) < PARALLEL;
    bool between = start == START_INSIDE || (lo < o && o < hi);
    float inverse = 1.0 / (parallel ? 1.0 : d);
    float t_lo = (lo - o) * inverse;
    float t_hi = (hi - o) * inverse;
    float far = between ? FAR : -FAR;
    return Slab(parallel ? -far : min2(t_lo, t_hi), parallel ? far : max2(t_lo, t_hi));
}

// Whether a ray meets a convex solid, which it crosses in the interval s, at its entry.
bool enters(Slab s, uint start) {
    return s.near > 0.0 && start == START_ELSEWHERE;
}

// Where a ray first meets a convex solid that it crosses in the interval s, or -1. If it leaves to the outside: never.
// To the inside: at the exit, t >= 0, always found. From elsewhere: the least t > 0.
float first_of(Slab s, uint start) {
    bool found = s.near <= s.far && s.far > 0.0 && start == START_ELSEWHERE;
    float t = enters(s, start) ? s.near : s.far;
    return start == START_INSIDE ? max2(s.far, 0.0) : (found ? t : -1.0);
}
