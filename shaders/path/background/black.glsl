// Nothing shines from outside.

vec3 background_seen(PathState s) {
    return vec3(0.0);
}
