// Nothing shines from outside.

vec3 background_seen(Subpath path) {
    return vec3(0.0);
}
