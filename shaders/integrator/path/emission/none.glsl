// No shape of this scene emits.

vec3 emission_seen(Subpath path, vec3 n, Vertex v, vec3 origin, float distance) {
    return vec3(0.0);
}
