// A light picked by its power, independently of the vertex; or the only one. Fills the slot <pick>.
// Twin of the functions of their names in src/reference/integrator/path/pick/mod.rs.
// uses: sampler/unit_float, integrator/path/pick/candidate, <light_choice>

Candidate pick(Subpath path, Vertex v, uvec4 u) {
    uint light = light_choice(u.x >> 8u);
    return candidate(path, v, light, light_pmf(light), u.y >> 8u, vec2(unit_float(u.z), unit_float(u.w)));
}

vec3 pick_normal(Vertex v) {
    return vec3(0.0);
}

float pick_probability(uint light, vec3 p, vec3 n) {
    return light_pmf(light);
}
