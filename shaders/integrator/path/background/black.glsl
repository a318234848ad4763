// The surroundings emit nothing.

vec3 background_seen(Subpath path, vec3 n, vec3 origin) {
    return vec3(0.0);
}
