// Few lights: each is a candidate at every vertex. Fills the slot <pick>.
// Twin of the functions of their names in src/reference/integrator/path/pick/mod.rs.
// uses: integrator/path/pick/every

Candidate pick(Subpath path, Vertex v, uvec4 u) {
    return pick_every(path, v, u);
}

vec3 pick_normal(Vertex v) {
    return vec3(0.0);
}

float pick_probability(uint light, vec3 p, vec3 n) {
    return 1.0;
}
