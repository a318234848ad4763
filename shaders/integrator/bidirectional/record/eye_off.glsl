// Records nothing of an eye path: a rendering.
// uses: integrator/bidirectional/joint

void record_hit(inout EyeState s, Joint x) {
}

void record_light(inout EyeState s, vec3 contribution, uint light) {
}

void record_arrival(inout EyeState s, vec3 contribution, bool arrives) {
}

void record_lobe(inout EyeState s, vec3 throughput, uint lobe) {
}

void record_escape(inout EyeState s, vec3 throughput) {
}

uint take_signature(inout EyeState s) {
    return 0u;
}
