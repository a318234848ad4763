// Records nothing of a light path: a rendering.
// uses: integrator/bidirectional/joint

void record_start(uint sample_index, uint thread) {
}

void record_hit(uint sample_index, uint thread, Joint y) {
}

void record_lobe(uint sample_index, uint thread, vec3 throughput, uint lobe) {
}

void record_escape(uint sample_index, uint thread, vec3 throughput) {
}
