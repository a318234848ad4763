// Records nothing.
// uses: path/vertex

void record_hit(inout PathState s, Subpath path, Vertex v) {
}

void record_light(inout PathState s, vec3 contribution, uint light) {
}

void record_vertex(inout PathState s, Subpath path, Vertex v, uint lobe) {
}

void record_connection(inout PathState s, ShadowRay shadow, bool visible) {
}

void record_escape(inout PathState s, Subpath path) {
}

void record_sample(inout PathState s, uint lane, uint index) {
}
