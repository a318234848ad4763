// Nothing is written down.
// uses: path/vertex

void record_hit(inout PathState s, Vertex v) {
}

void record_light(inout PathState s, uint light) {
}

void record_vertex(inout PathState s, Vertex v, uint lobe) {
}

void record_connection(inout PathState s, bool visible) {
}

void record_escape(inout PathState s) {
}

void record_sample(inout PathState s, uint lane, uint index) {
}
