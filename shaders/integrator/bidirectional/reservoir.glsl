// Vertices of a light path to which eye paths are joined.
// Twin of src/reference/integrator/bidirectional/reservoir.rs.
// uses: constants/bidirectional, constants/material_kind, math/finite

// Whether a material has a lobe with a density, at which paths can be joined.
bool has_density(uint kind, vec3 kd) {
    bool smooth_only = kind == KIND_MIRROR || kind == KIND_SMOOTH_DIELECTRIC;
    bool none = kind == KIND_BLACK || kind == KIND_NULL_INTERFACE;
    return !none && !(smooth_only && is_black(kd));
}

// Where a vertex is to be kept after `seen` others; KEPT or more means not at all. All have the same probability, by
// the uniform number u (Vitter, Random Sampling with a Reservoir, 1985, algorithm R).
uint kept_place(uint seen, float u) {
    return seen < KEPT ? seen : uint(u * float(seen + 1u));
}

// The number of vertices that each kept one represents.
float kept_share(uint seen) {
    return float(seen < KEPT ? KEPT : seen) / float(KEPT);
}
