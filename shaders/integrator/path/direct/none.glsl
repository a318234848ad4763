// No connections to lights: the scene has no lights, or the settings no connections.
// uses: path/vertex

ShadowRay connect(inout PathState s, Subpath path, Vertex v, uint pixel_index, uint sample_index) {
    ShadowRay shadow;
    shadow.pending = 0u;
    return shadow;
}
