// Few lights or many, depending on the scene: for kernels that several scenes share. Fills the slot <pick>.
// Twin of the functions of their names in src/reference/integrator/path/pick/mod.rs.
// uses: constants/lights, light/tree/descent, integrator/path/pick/every, integrator/path/pick/tree

Candidate pick(Subpath path, Vertex v, uvec4 u) {
    Candidate c;
    if (LIGHTS <= FEW_LIGHTS) {
        c = pick_every(path, v, u);
    } else {
        c = pick_in_tree(path, v, u);
    }
    return c;
}

vec3 pick_normal(Vertex v) {
    return LIGHTS <= FEW_LIGHTS ? vec3(0.0) : lit_side(v);
}

float pick_probability(uint light, vec3 p, vec3 n) {
    float among_many = tree_pmf(light_trails[light], p, n);
    return LIGHTS <= FEW_LIGHTS ? 1.0 : among_many;
}
