// Tests a ray against the eight boxes of a node, so that no box hides a hit inside it.
//
// The padding, its proof and its constants: src/reference/accel/slabs.rs. Here a box has planes at
// origin + q 2^k, q in 0 ... 255, on three axes. The parameter of a plane is one product and one sum from those of
// the grid:  (origin + q 2^k - o)/d = (origin - o)(1/d) + q (2^k/d).
// Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, HPG 2017,
// section 3.2 and listing 1.

// uses: math/vec

// The part of a ray's box tests that all boxes share.
struct Slabs {
    vec3 inverse;   // 1/d
    vec3 entering;  // o moved forward along each axis by the padding, for planes through which the ray enters
    vec3 leaving;   // o moved back, for planes through which it leaves
    uint octant;    // 4, 2, 1: d.x, d.y, d.z are positive
};

// x, or 2^-48 with its sign if it is smaller.
float away_from_zero(float x) {
    float tiny = 3.552713678800501e-15;
    return abs(x) < tiny ? (x < 0.0 ? -tiny : tiny) : x;
}

// reach: the largest absolute coordinate of any box.
Slabs slabs_of(vec3 o, vec3 d, float reach) {
    vec3 e = vec3(away_from_zero(d.x), away_from_zero(d.y), away_from_zero(d.z));
    // 64 u R with u = 2^-24
    float pad = 3.814697265625e-6 * (max2(max2(abs(o.x), abs(o.y)), abs(o.z)) + reach);
    vec3 shift = vec3(e.x < 0.0 ? -pad : pad, e.y < 0.0 ? -pad : pad, e.z < 0.0 ? -pad : pad);
    uint octant = (e.x < 0.0 ? 0u : 4u) | (e.y < 0.0 ? 0u : 2u) | (e.z < 0.0 ? 0u : 1u);
    return Slabs(vec3(1.0) / e, o + shift, o - shift, octant);
}

// Byte i of a word, as a number.
float plane(uint word, uint i) {
    return float(int((word >> (8u * i)) & 0xffu));
}

// A node's grid relative to a ray, and the words of four children's planes.
struct Half {
    vec3 step;    // 2^k/d
    vec3 enter;   // parameter of plane 0, the origin moved forward
    vec3 leave;   // parameter of plane 0, the origin moved back
    uvec3 near;   // planes through which the ray enters
    uvec3 far;    // planes through which it leaves
    uint bits;    // per child: its bits in the mask ...
    uint shifts;  // ... and their position
};

// The contribution of child i of the four to the mask: none if the ray misses it or enters it beyond t_max. At t_max
// itself counts: the nearest hit may be one of several at the same distance.
uint child_hit(Half h, uint i, float t_max) {
    vec3 near = vec3(plane(h.near.x, i), plane(h.near.y, i), plane(h.near.z, i)) * h.step + h.enter;
    vec3 far = vec3(plane(h.far.x, i), plane(h.far.y, i), plane(h.far.z, i)) * h.step + h.leave;
    float entry = max2(max2(near.x, near.y), max2(near.z, 0.0));
    float exit = min2(min2(far.x, far.y), min2(far.z, t_max));
    uint bits = ((h.bits >> (8u * i)) & 7u) << ((h.shifts >> (8u * i)) & 31u);
    return entry <= exit ? bits : 0u;
}

uint half_hits(Half h, float t_max) {
    return child_hit(h, 0u, t_max) | child_hit(h, 1u, t_max) | child_hit(h, 2u, t_max) | child_hit(h, 3u, t_max);
}

// Which children of the node a ray meets. Bits 24 ... 31: inner children, the one to enter first highest; bits
// 0 ... 23: references of leaves. Words of the node: see src/flat/bvh/mod.rs.
uint node_hits(Slabs s, uvec4 head, uvec2 meta, uvec4 x, uvec4 y, uvec4 z, float t_max) {
    vec3 cell = uintBitsToFloat(uvec3(head.w & 0xffu, (head.w >> 8u) & 0xffu, (head.w >> 16u) & 0xffu) << 23u);
    vec3 origin = uintBitsToFloat(head.xyz);
    vec3 step = cell * s.inverse;
    vec3 enter = (origin - s.entering) * s.inverse;
    vec3 leave = (origin - s.leaving) * s.inverse;
    bvec3 back = bvec3(s.inverse.x < 0.0, s.inverse.y < 0.0, s.inverse.z < 0.0);
    // Bits 3 and 4 of a byte are both set for an inner child only; its slot is then taken relative to the octant.
    uvec2 inner = ((meta & (meta << 1u)) & 0x10101010u) >> 4u;
    uvec2 shifts = (meta ^ (inner * s.octant)) & 0x1f1f1f1fu;
    uvec2 bits = (meta >> 5u) & 0x07070707u;
    uvec3 near = uvec3(back.x ? x.z : x.x, back.y ? y.z : y.x, back.z ? z.z : z.x);
    uvec3 far = uvec3(back.x ? x.x : x.z, back.y ? y.x : y.z, back.z ? z.x : z.z);
    uint lower = half_hits(Half(step, enter, leave, near, far, bits.x, shifts.x), t_max);
    near = uvec3(back.x ? x.w : x.y, back.y ? y.w : y.y, back.z ? z.w : z.y);
    far = uvec3(back.x ? x.y : x.w, back.y ? y.y : y.w, back.z ? z.y : z.w);
    return lower | half_hits(Half(step, enter, leave, near, far, bits.y, shifts.y), t_max);
}
