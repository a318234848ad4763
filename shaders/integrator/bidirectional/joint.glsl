// A vertex that a path is joined at.
// Twin of struct Joint in src/reference/integrator/bidirectional/join.rs.
// uses: constants/bidirectional, path/vertex, integrator/bidirectional/partial

// One end of a connection.
struct Joint {
    Vertex v;
    // Whence its path came, of unit length.
    vec3 wo;
    // Throughput, or power.
    vec3 carried;
    // The medium that its path came through.
    uint medium;
    Partial partial;
    // Vertices of its path up to this one.
    uint count;
};

// Where number `place` lies of the `kept` that each of a thread's samples has.
uint kept_index(uint kept, uint place, uint sample_index, uint thread) {
    uint threads = job.tile_width * job.tile_height;
    return ((sample_index - job.sample_begin) * kept + place) * threads + thread;
}

// Writes a vertex of a light path down.
void keep_vertex(Joint y, uint place, uint sample_index, uint thread) {
    light_vertices[kept_index(KEPT, place, sample_index, thread)] =
        LightVertex(y.v.p, y.v.shape, y.v.ng, y.v.prim, y.v.ns, y.medium, y.wo, y.count, y.carried, 0u, y.partial.vcm,
                    y.partial.vc, 0u, 0u);
}

// A vertex that was written down.
Joint kept_vertex(uint place, uint sample_index, uint thread) {
    LightVertex y = light_vertices[kept_index(KEPT, place, sample_index, thread)];
    Vertex v = vertex_at(Surface(y.p, y.ng, y.ns), y.shape, y.prim, y.wo);
    return Joint(v, y.wo, y.power, y.medium, Partial(y.vcm, y.vc), y.count);
}
