// The decisions of every path, hashed, for `compare --paired`, and the value of each sample. The kernel traces a
// connection a turn after its vertex: vertices and connections each have a chain, both in the order of the reference.
// Twin of src/reference/integrator/path/signature.rs.
// uses: constants/decision, path/vertex, integrator/path/signature

void record_hit(inout PathState s, Subpath path, Vertex v) {
    s.recorded = decide(s.recorded, is_light(path.throughput), DECISION_SHAPE, v.shape);
}

void record_light(inout PathState s, vec3 contribution, uint light) {
    s.connected = decide(s.connected, is_light(contribution), DECISION_LIGHT, light);
}

void record_vertex(inout PathState s, Subpath path, Vertex v, uint lobe) {
    s.recorded = decide(s.recorded, is_light(path.throughput), DECISION_LOBE, lobe);
}

void record_connection(inout PathState s, ShadowRay shadow, bool visible) {
    bool arrived = visible && is_light(shadow.contribution);
    s.connected = decide(s.connected, arrived, DECISION_ARRIVAL, 0u);
}

void record_escape(inout PathState s, Subpath path) {
    s.recorded = decide(s.recorded, is_light(path.throughput), DECISION_ESCAPE, 0u);
}

void record_sample(inout PathState s, uint lane, uint index) {
    outcomes[lane * OUTCOMES + index] = PathOutcome(s.radiance, path_signature(s.recorded, s.connected));
    s.recorded = 0u;
    s.connected = 0u;
}
