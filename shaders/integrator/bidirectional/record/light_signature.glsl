// The decisions at a light path's vertices, for `compare --paired`: a chain next to the path's reservoir.
// Twin of src/reference/integrator/bidirectional/signature.rs.
// uses: constants/decision, integrator/bidirectional/joint, integrator/path/signature

void decide_light(uint sample_index, uint thread, bool matters, uint decision, uint what) {
    uint at = kept_index(1u, 0u, sample_index, thread);
    reservoirs[at].decided = decide(reservoirs[at].decided, matters, decision, what);
}

void record_start(uint sample_index, uint thread) {
    reservoirs[kept_index(1u, 0u, sample_index, thread)].decided = 0u;
}

void record_hit(uint sample_index, uint thread, Joint y) {
    decide_light(sample_index, thread, is_light(y.carried), DECISION_SHAPE, y.v.shape);
}

void record_lobe(uint sample_index, uint thread, vec3 throughput, uint lobe) {
    decide_light(sample_index, thread, is_light(throughput), DECISION_LOBE, lobe);
}

void record_escape(uint sample_index, uint thread, vec3 throughput) {
    decide_light(sample_index, thread, is_light(throughput), DECISION_ESCAPE, 0u);
}
