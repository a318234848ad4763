// No shape of this scene emits.
// uses: path/vertex, integrator/bidirectional/partial

vec3 emission_seen(Subpath path, Partial partial, vec3 n, Vertex v, vec3 origin, float distance) {
    return vec3(0.0);
}
