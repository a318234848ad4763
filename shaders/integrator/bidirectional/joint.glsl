// A vertex where a path is joined.
// Twin of struct Joint in src/reference/integrator/bidirectional/join.rs.
// uses: constants/bidirectional, path/vertex, integrator/bidirectional/partial

// One end of a connection.
struct Joint {
    Vertex v;
    // Back along its path, of unit length.
    vec3 wo;
    // Throughput, or power.
    vec3 carried;
    // The medium through which its path came.
    uint medium;
    Partial partial;
    // Vertices of its path up to this one.
    uint count;
};

// The index of number `place` of the `kept` vertices that each of a thread's samples has.
uint kept_index(uint kept, uint place, uint sample_index, uint thread) {
    uint threads = job.tile_width * job.tile_height;
    return ((sample_index - job.sample_begin) * kept + place) * threads + thread;
}

// Stores a vertex of a light path.
void keep_vertex(Joint y, uint place, uint sample_index, uint thread) {
    light_vertices[kept_index(KEPT, place, sample_index, thread)] =
        LightVertex(y.v.p, y.v.shape, y.v.ng, y.v.prim, y.v.ns, y.medium, y.wo, y.count, y.carried, 0u, y.partial.vcm,
                    y.partial.vc, 0u, 0u);
}

// A stored vertex.
Joint kept_vertex(uint place, uint sample_index, uint thread) {
    LightVertex y = light_vertices[kept_index(KEPT, place, sample_index, thread)];
    Vertex v = vertex_at(Surface(y.p, y.ng, y.ns), y.shape, y.prim, y.wo);
    return Joint(v, y.wo, y.power, y.medium, Partial(y.vcm, y.vc), y.count);
}
