// No connections to lights: there are none, or they were not asked for.
// uses: path/vertex

ShadowRay connect(inout PathState s, Subpath path, Vertex v, uint pixel_index, uint sample_index) {
    ShadowRay shadow;
    shadow.pending = 0u;
    return shadow;
}
