// Nothing is written down.
// uses: path/vertex

void record_vertex(inout PathState s, Vertex v, uint lobe) {
}

void record_connection(inout PathState s, bool visible) {
}

void record_escape(inout PathState s) {
}
