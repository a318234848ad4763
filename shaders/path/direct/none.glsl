// No connections to lights: there are none, or they were not asked for.

void connect(inout PathState s, Vertex v, uint pixel_index) {
    s.connecting = 0u;
}
