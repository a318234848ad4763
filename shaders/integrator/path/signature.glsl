// The decisions of a path as one word: two paths with the same decisions have the same word.
// Twin of src/reference/integrator/path/signature.rs.
// uses: constants/decision, math/vec, sampler/pcg4d

// `chain` with one more decision, its kind and its value; unchanged unless the decision `matters`.
uint decide(uint chain, bool matters, uint decision, uint what) {
    // Before the choice, not inside it: naga makes `?:` a branch, and on that one Mesa 22.3's compiler crashed.
    uint longer = pcg4d(uvec4(chain, decision, what, 0u)).x;
    return matters ? longer : chain;
}

// Whether this radiance is above zero.
bool is_light(vec3 radiance) {
    return max_component(radiance) > DARK;
}

// The signature of a path whose vertices and connections made these chains.
uint path_signature(uint vertices, uint connections) {
    return decide(vertices, true, 0u, connections);
}
