// Many lights: one is picked in the tree. Fills the slot <pick>.
// Twin of the functions of their names in src/reference/integrator/path/pick/mod.rs.
// uses: light/tree/descent, integrator/path/pick/tree

Candidate pick(Subpath path, Vertex v, uvec4 u) {
    return pick_in_tree(path, v, u);
}

vec3 pick_normal(Vertex v) {
    return lit_side(v);
}

float pick_probability(uint light, vec3 p, vec3 n) {
    return tree_pmf(light_trails[light], p, n);
}
