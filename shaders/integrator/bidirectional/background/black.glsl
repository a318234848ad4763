// The surroundings emit nothing.
// uses: integrator/bidirectional/partial

vec3 background_seen(Subpath path, Partial partial, vec3 n, vec3 origin) {
    return vec3(0.0);
}
