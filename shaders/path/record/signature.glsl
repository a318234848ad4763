// The decisions of every path, hashed, for `compare --paired`, and what each sample came to. The kernel flies a
// connection a turn after its vertex: vertices and connections each have a chain, both in the order of the reference.
// Twin of src/reference/path/signature.rs.
// uses: path/vertex, path/signature

void record_hit(inout PathState s, Vertex v) {
    s.recorded = decide(s.recorded, is_light(s.throughput), DECISION_SHAPE, v.shape);
}

void record_light(inout PathState s, uint light) {
    s.connected = decide(s.connected, is_light(s.throughput), DECISION_LIGHT, light);
}

void record_vertex(inout PathState s, Vertex v, uint lobe) {
    s.recorded = decide(s.recorded, is_light(s.throughput), DECISION_LOBE, lobe);
}

void record_connection(inout PathState s, bool visible) {
    bool arrived = visible && is_light(s.contribution);
    s.connected = decide(s.connected, arrived, DECISION_ARRIVAL, 0u);
}

void record_escape(inout PathState s) {
    s.recorded = decide(s.recorded, is_light(s.throughput), DECISION_ESCAPE, 0u);
}

void record_sample(inout PathState s, uint lane, uint index) {
    outcomes[lane * OUTCOMES + index] = PathOutcome(s.radiance, path_signature(s.recorded, s.connected));
    s.recorded = 0u;
    s.connected = 0u;
}
