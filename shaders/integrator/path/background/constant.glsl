// Constant radiance of everything outside, found by a path that leaves the scene.
// uses: light/background, <light_choice>, <connect>

vec3 background_seen(Subpath path) {
    float q = light_pmf(BACKGROUND_LIGHT) * background_light_pdf();
    return lights[BACKGROUND_LIGHT].radiance * hit_weight(path.delta != 0u, path.pdf, q);
}
