// Nothing emits: no light path has a vertex. Fills the slot <first_partial>.
// uses: path/vertex, integrator/bidirectional/partial

Partial first_partial(LightState s, Vertex v, vec3 wo, float distance) {
    return Partial(0.0, 0.0);
}
