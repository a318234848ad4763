// No light is picked: the scene has none, or paths find it by hits alone. Fills the slot <pick>.
// uses: path/vertex

vec3 pick_normal(Vertex v) {
    return vec3(0.0);
}

float pick_probability(uint light, vec3 p, vec3 n) {
    return 0.0;
}
