// Every event of a path, in order, for `--trace`; events that do not fit are dropped.
// uses: constants/none, constants/record, path/vertex

void record(inout PathState s, Record event) {
    if (s.recorded < RECORDS) {
        records[s.recorded] = event;
    }
    s.recorded += 1u;
}

// The vertex is recorded once it is shaded.
void record_hit(inout PathState s, Subpath path, Vertex v) {
}

// Records a connection with its light.
void record_light(inout PathState s, vec3 contribution, uint light) {
}

void record_vertex(inout PathState s, Subpath path, Vertex v, uint lobe) {
    record(s, Record(RECORD_VERTEX, lobe, v.shape, v.prim, v.p, path.pdf, path.throughput, path.ray.medium, s.radiance, 0u));
}

void record_connection(inout PathState s, ShadowRay shadow, bool visible) {
    record(s, Record(RECORD_CONNECTION, visible ? 1u : 0u, shadow.target_shape, shadow.target_prim,
                     shadow.ray.d, 0.0, shadow.contribution, shadow.ray.medium, s.radiance, 0u));
}

void record_escape(inout PathState s, Subpath path) {
    record(s, Record(RECORD_ESCAPE, 0u, NONE, NONE, path.ray.d, path.pdf, path.throughput, path.ray.medium, s.radiance, 0u));
}

// There is one sample.
void record_sample(inout PathState s, uint lane, uint index) {
}
