// Constant radiance of everything outside, found by a path that leaves the scene.
// uses: light/background, <pick>, <connect>

vec3 background_seen(Subpath path, vec3 n, vec3 origin) {
    float q = pick_probability(BACKGROUND_LIGHT, origin, n) * background_light_pdf();
    return lights[BACKGROUND_LIGHT].radiance * hit_weight(path.delta != 0u, path.pdf, q);
}
