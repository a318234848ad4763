// There is no light to connect a vertex to.
// uses: path/vertex, integrator/bidirectional/partial

ShadowRay join_light(inout EyeState s, Subpath path, Vertex v, Partial partial, uint pixel_index, uint sample_index) {
    ShadowRay shadow;
    shadow.pending = 0u;
    return shadow;
}
