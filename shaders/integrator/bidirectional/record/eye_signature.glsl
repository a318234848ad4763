// The decisions of an eye path, for `compare --paired`: its vertices and its connections each have a chain.
// Twin of src/reference/integrator/bidirectional/signature.rs.
// uses: constants/decision, integrator/bidirectional/joint, integrator/path/signature

void record_hit(inout EyeState s, Joint x) {
    s.recorded = decide(s.recorded, is_light(x.carried), DECISION_SHAPE, x.v.shape);
}

void record_light(inout EyeState s, vec3 contribution, uint light) {
    s.connected = decide(s.connected, is_light(contribution), DECISION_LIGHT, light);
}

void record_arrival(inout EyeState s, vec3 contribution, bool arrives) {
    s.connected = decide(s.connected, arrives && is_light(contribution), DECISION_ARRIVAL, 0u);
}

void record_lobe(inout EyeState s, vec3 throughput, uint lobe) {
    s.recorded = decide(s.recorded, is_light(throughput), DECISION_LOBE, lobe);
}

void record_escape(inout EyeState s, vec3 throughput) {
    s.recorded = decide(s.recorded, is_light(throughput), DECISION_ESCAPE, 0u);
}

// The word of the sample that is complete; the next has none yet.
uint take_signature(inout EyeState s) {
    uint word = path_signature(s.recorded, s.connected);
    s.recorded = 0u;
    s.connected = 0u;
    return word;
}
